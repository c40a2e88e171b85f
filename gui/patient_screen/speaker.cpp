// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/speaker.hpp"

#include <QAudioDeviceInfo>
#include <QAudioOutput>
#include <QCoreApplication>
#include <QIODevice>
#include <QLocale>
#include <QTextToSpeech>
#include <algorithm>
#include <cstdint>
#include <mutex>

namespace isograsp::gui {

namespace {

struct SpeakerTexts {
  Q_DECLARE_TR_FUNCTIONS(Speaker)
};

QAudioFormat format() {
  QAudioFormat format;
  format.setSampleRate(kSoundRate_Hz);
  format.setChannelCount(1);
  format.setSampleSize(16);
  format.setCodec(QStringLiteral("audio/pcm"));
  format.setByteOrder(QAudioFormat::LittleEndian);
  format.setSampleType(QAudioFormat::SignedInt);
  return format;
}

}  // namespace

/// The samples that the sound card reads: tones that have not ended, and the force. Read on a
/// thread of the sound system.
class ToneMixer final : public QIODevice {
 public:
  void play(Tone tone) {
    auto samples = samples_of(tone);
    const std::lock_guard lock(mutex_);
    tone_ = std::move(samples);
    next_ = 0;
  }
  void hear(const HeardForce& force) {
    const std::lock_guard lock(mutex_);
    force_ = force;
  }

  [[nodiscard]] bool isSequential() const override { return true; }
  [[nodiscard]] qint64 bytesAvailable() const override {
    return QIODevice::bytesAvailable() + kAlways_bytes;
  }

 protected:
  qint64 readData(char* data, qint64 room_bytes) override {
    const auto count = static_cast<std::size_t>(room_bytes) / sizeof(std::int16_t);
    auto* const out = reinterpret_cast<std::int16_t*>(data);
    const std::lock_guard lock(mutex_);
    mixed_.clear();
    force_tone_.play(force_, count, mixed_);
    constexpr float kFull = 32000.0F;
    for (std::size_t k = 0; k < count; ++k) {
      const float tone = next_ < tone_.size() ? tone_[next_++] : 0.0F;
      out[k] = static_cast<std::int16_t>(kFull * std::clamp(mixed_[k] + tone, -1.0F, 1.0F));
    }
    return static_cast<qint64>(count * sizeof(std::int16_t));
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  static constexpr qint64 kAlways_bytes = 1 << 16;
  std::mutex mutex_;
  std::vector<float> tone_;
  std::size_t next_ = 0;
  HeardForce force_;
  ForceTone force_tone_;
  std::vector<float> mixed_;
};

namespace {

QString why_silent() {
  const auto device = QAudioDeviceInfo::defaultOutputDevice();
  if (device.isNull())
    return SpeakerTexts::tr(
        "This computer has no sound output: connect a loudspeaker, then try again.");
  if (!device.isFormatSupported(format()))
    return SpeakerTexts::tr(
        "The sound output does not take 44.1 kHz, 16 bit: choose another one in the "
        "settings of the desktop.");
  return {};
}

}  // namespace

struct Speaker::Parts {
  int volume_percent = 50;
  ToneMixer mixer;
  std::unique_ptr<QAudioOutput> output;
  std::unique_ptr<QTextToSpeech> voice;

  /// Opens the output in the first call; returns why it cannot.
  QString open() {
    if (output == nullptr) {
      if (auto why = why_silent(); !why.isEmpty()) return why;
      output = std::make_unique<QAudioOutput>(format());
      output->setBufferSize(kSoundRate_Hz / 10);  // 50 ms: what is heard belongs to what is felt
      output->setVolume(volume_percent / 100.0);
      mixer.open(QIODevice::ReadOnly);
      output->start(&mixer);
    }
    return {};
  }
};

Speaker::Speaker() : parts_(std::make_unique<Parts>()) {}
Speaker::~Speaker() {
  if (parts_->output != nullptr) parts_->output->stop();
}

QString Speaker::why_mute() {
  if (parts_->voice == nullptr) parts_->voice = std::make_unique<QTextToSpeech>();
  if (parts_->voice->state() == QTextToSpeech::BackendError)
    return SpeakerTexts::tr(
        "This computer has no voice: install speech-dispatcher with a voice such as "
        "espeak-ng.");
  const auto language = QLocale().language();
  const auto spoken = parts_->voice->availableLocales();
  if (std::none_of(spoken.begin(), spoken.end(),
                   [&](const QLocale& locale) { return locale.language() == language; }))
    return SpeakerTexts::tr("The voice of this computer does not speak %1: install one that does.")
        .arg(QLocale().nativeLanguageName());
  return {};
}

void Speaker::set_volume(int percent) {
  if (percent == parts_->volume_percent) return;
  parts_->volume_percent = percent;
  if (parts_->output != nullptr) parts_->output->setVolume(percent / 100.0);
  if (parts_->voice != nullptr) parts_->voice->setVolume(percent / 100.0);
}

QString Speaker::play(Tone tone) {
  auto why = parts_->open();
  if (why.isEmpty()) parts_->mixer.play(tone);
  return why;
}

QString Speaker::hear(const HeardForce& force) {
  if (parts_->output == nullptr && !force.heard) return {};
  auto why = parts_->open();
  if (why.isEmpty()) parts_->mixer.hear(force);
  return why;
}

QString Speaker::speak(const QString& words) {
  if (auto why = why_mute(); !why.isEmpty()) return why;
  auto& voice = *parts_->voice;
  voice.stop();
  voice.setLocale(QLocale());
  voice.setVolume(parts_->volume_percent / 100.0);
  voice.say(words);
  return {};
}

void Speaker::be_silent() {
  parts_->mixer.hear({});
  if (parts_->voice != nullptr) parts_->voice->stop();
}

}  // namespace isograsp::gui
