// SPDX-License-Identifier: GPL-3.0-or-later
// Dormand-Prince 8(5,3): explicit Runge-Kutta of order 8 with two embedded formulas for the error.
// Coefficients: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I,
// 2nd ed., sect. II.5 and the program DOP853; here to 24 digits.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace isograsp::dormand_prince {

// clang-format off
/// Stages with a weight: a quadrature of order 8 along the solution.
inline constexpr std::array<std::size_t, 8> kWeighted{0, 5, 6, 7, 8, 9, 10, 11};
inline constexpr std::array<double, 8> kTime{0.0, 0.333333333333333333333333, 0.25, 0.307692307692307692307692, 0.651282051282051282051282, 0.6, 0.857142857142857142857143, 1.0};
inline constexpr std::array<double, 8> kWeight{0.0542937341165687622380536, 4.45031289275240888144114, 1.89151789931450038304282, -5.80120396001058478146721, 0.311164366957819894408916, -0.152160949662516078556179, 0.201365400804030348374777, 0.0447106157277725905176886};

/// Rates k[i] = f(i, y_i) at the stages of a step of y' = f(y).
template <class State, class Rate>
[[gnu::always_inline]] inline void stages(const State& y, typename State::Scalar h, const Rate& f, std::array<State, 12>& k) {
  k[0] = f(0, y);
  k[1] = f(1, y + h * (0.0526001519587677318785588 * k[0]));
  k[2] = f(2, y + h * (0.0197250569845378994544595 * k[0] + 0.0591751709536136983633786 * k[1]));
  k[3] = f(3, y + h * (0.0295875854768068491816893 * k[0] + 0.0887627564304205475450679 * k[2]));
  k[4] = f(4, y + h * (0.241365134159266685502370 * k[0] - 0.884549479328286085344865 * k[2] + 0.924834003261792003115738 * k[3]));
  k[5] = f(5, y + h * (0.0370370370370370370370370 * k[0] + 0.170828608729473871279604 * k[3] + 0.125467687566822425016692 * k[4]));
  k[6] = f(6, y + h * (0.037109375 * k[0] + 0.170252211019544039314978 * k[3] + 0.0602165389804559606850219 * k[4] - 0.017578125 * k[5]));
  k[7] = f(7, y + h * (0.0370920001185047927108779 * k[0] + 0.170383925712239993810214 * k[3] + 0.107262030446373284651809 * k[4] - 0.0153194377486244017527936 * k[5] + 0.00827378916381402288758474 * k[6]));
  k[8] = f(8, y + h * (0.624110958716075717114430 * k[0] - 3.36089262944694129406857 * k[3] - 0.868219346841726006818190 * k[4] + 27.5920996994467083049416 * k[5] + 20.1540675504778934086187 * k[6] - 43.4898841810699588477366 * k[7]));
  k[9] = f(9, y + h * (0.477662536438264365890434 * k[0] - 2.48811461997166764192643 * k[3] - 0.590290826836842996371446 * k[4] + 21.2300514481811942347289 * k[5] + 15.2792336328824235832597 * k[6] - 33.2882109689848629194453 * k[7] - 0.0203312017085086261358223 * k[8]));
  k[10] = f(10, y + h * (-0.937142430085987325717040 * k[0] + 5.18637242884406370830024 * k[3] + 1.09143734899672957818500 * k[4] - 8.14978701074692612513997 * k[5] - 18.5200656599969598641566 * k[6] + 22.7394870993505042818970 * k[7] + 2.49360555267965238987089 * k[8] - 3.04676447189821950038237 * k[9]));
  k[11] = f(11, y + h * (2.27331014751653820792360 * k[0] - 10.5344954667372501984067 * k[3] - 2.00087205822486249909676 * k[4] - 17.9589318631187989172766 * k[5] + 27.9488845294199600508500 * k[6] - 2.85899827713502369474066 * k[7] - 8.87285693353062954433549 * k[8] + 12.3605671757943030647266 * k[9] + 0.643392746015763530355970 * k[10]));
}

template <class State>
[[nodiscard, gnu::always_inline]] inline State increment(const std::array<State, 12>& k) {
  return 0.0542937341165687622380536 * k[0] + 4.45031289275240888144114 * k[5] + 1.89151789931450038304282 * k[6] - 5.80120396001058478146721 * k[7] + 0.311164366957819894408916 * k[8] - 0.152160949662516078556179 * k[9] + 0.201365400804030348374777 * k[10] + 0.0447106157277725905176886 * k[11];
}
/// Errors of the embedded formulas of order 5 and 3, per unit of h.
template <class State>
[[nodiscard, gnu::always_inline]] inline State error5(const std::array<State, 12>& k) {
  return 0.0131200449941948807325010 * k[0] - 1.22515644637620444072057 * k[5] - 0.495758949657250191521408 * k[6] + 1.66437718245498653696153 * k[7] - 0.350328848749973681688649 * k[8] + 0.334179118713017479029732 * k[9] + 0.0819232064851157124657074 * k[10] - 0.0223553078638862952588443 * k[11];
}
template <class State>
[[nodiscard, gnu::always_inline]] inline State error3(const std::array<State, 12>& k) {
  return -0.189800754072407615714702 * k[0] + 4.45031289275240888144114 * k[5] + 1.89151789931450038304282 * k[6] - 5.80120396001058478146721 * k[7] - 0.422682321323791962932446 * k[8] - 0.152160949662516078556179 * k[9] + 0.201365400804030348374777 * k[10] + 0.0226517921983608258118062 * k[11];
}
// clang-format on
/// Hairer's combination of the errors of the embedded formulas.
[[nodiscard, gnu::always_inline]] inline double combined(double h_s, double error5,
                                                         double error3) noexcept {
  const double both = error5 * error5 + 0.01 * error3 * error3;
  return both == 0.0 ? 0.0 : h_s * error5 * error5 / std::sqrt(both);
}
/// Of a turning body: error of the attitude from the angles that error5 and error3 mean, and from
/// the same with what their velocities turn in a step.
[[nodiscard, gnu::always_inline]] inline double estimate(double h_s, double angle5, double angle3,
                                                         double size5, double size3) noexcept {
  return std::max(combined(h_s, angle5, angle3), 0.5 * combined(h_s, size5, size3));
}
/// What order 5 would have erred by, per unit of h: the fourth difference of the rates, at 0, 1/4,
/// 3/5, 6/7, 1.
template <class State>
[[nodiscard, gnu::always_inline]] inline State coarser(const std::array<State, 12>& k) {
  return 0.07777777777777778 * k[0] - 0.25098039215686274 * k[6] + 0.46296296296296297 * k[9] -
         0.5230936819172113 * k[10] + 0.23333333333333334 * k[11];
}

}  // namespace isograsp::dormand_prince
