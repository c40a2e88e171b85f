<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Compensation</name>
    <message>
        <source>This measures the shoulder, too: the arm pushes the platform with %1 % of the grip. Let it rest on the support.</source>
        <translation>Hier wird auch die Schulter gemessen: Der Arm drückt mit %1 % des Griffs gegen die Plattform. Lassen Sie ihn auf der Stütze ruhen.</translation>
    </message>
    <message>
        <source>%1 moved %2 mm on its support: seat it anew.</source>
        <translation>%1: auf der Auflage um %2 mm verrutscht, bitte neu anlegen.</translation>
    </message>
    <message>
        <source>%1 slips: more force into the object, less along it.</source>
        <translation>%1 rutscht: mehr Kraft in das Objekt hinein, weniger an ihm entlang.</translation>
    </message>
</context>
<context>
    <name>DeviceList</name>
    <message>
        <source>Force sensors on %1</source>
        <translation>Kraftsensoren an %1</translation>
    </message>
    <message>
        <source>Simulated patient, healthy</source>
        <translation>Simulierter Patient, gesund</translation>
    </message>
    <message>
        <source>Simulated patient, paretic</source>
        <translation>Simulierter Patient, paretisch</translation>
    </message>
    <message>
        <source>A recording …</source>
        <translation>Eine Aufzeichnung …</translation>
    </message>
</context>
<context>
    <name>Flow</name>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Connecting …</source>
        <translation>Verbindung wird hergestellt …</translation>
    </message>
    <message>
        <source>Saving and disconnecting …</source>
        <translation>Speichern und Trennen …</translation>
    </message>
    <message>
        <source>The recording is over</source>
        <translation>Die Aufzeichnung ist zu Ende</translation>
    </message>
    <message>
        <source>The device sends no more forces</source>
        <translation>Das Gerät sendet keine Kräfte mehr</translation>
    </message>
    <message>
        <source>No forces arrive: check the cable and power of the device</source>
        <translation>Es kommen keine Kräfte an: Kabel und Stromversorgung des Geräts prüfen</translation>
    </message>
    <message>
        <source>Waiting for the first forces …</source>
        <translation>Warten auf die ersten Kräfte …</translation>
    </message>
    <message>
        <source>Connected, but samples were missing</source>
        <translation>Verbunden, aber Messwerte fehlten</translation>
    </message>
    <message>
        <source>Measuring the empty device …</source>
        <translation>Das leere Gerät wird gemessen …</translation>
    </message>
    <message>
        <source>Connected, needs its zero</source>
        <translation>Verbunden, Nullabgleich fehlt</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Maximum %1 N.</source>
        <translation>Maximum %1 N.</translation>
    </message>
    <message>
        <source>Hand strapped. It settles: %1 s until the resting force.</source>
        <translation>Hand angegurtet. Sie kommt zur Ruhe: noch %1 s bis zur Ruhekraft.</translation>
    </message>
    <message>
        <source>The hand has settled. It relaxes: start the resting force.</source>
        <translation>Die Hand ist zur Ruhe gekommen. Sie entspannt sich: Messen Sie die Ruhekraft.</translation>
    </message>
    <message>
        <source>%1 Strap the hand in and say so; after a minute start the resting force.</source>
        <translation>%1 Gurten Sie die Hand an und bestätigen Sie es; messen Sie nach einer Minute die Ruhekraft.</translation>
    </message>
    <message>
        <source>Zero is set.</source>
        <translation>Der Nullabgleich ist erfolgt.</translation>
    </message>
    <message>
        <source>The protocol is finished. Write the report, or disconnect to end.</source>
        <translation>Das Protokoll ist beendet. Schreiben Sie den Bericht oder trennen Sie die Verbindung.</translation>
    </message>
    <message>
        <source>Take the hand out, then set the zero of the empty device once more.</source>
        <translation>Nehmen Sie die Hand heraus und wiederholen Sie den Nullabgleich des leeren Geräts.</translation>
    </message>
    <message>
        <source>Pause: %1 s to rest.</source>
        <translation>Pause: noch %1 s Ruhe.</translation>
    </message>
    <message>
        <source>Next, in %1 s: %2.</source>
        <translation>Als Nächstes, in %1 s: %2.</translation>
    </message>
    <message>
        <source>Next: %1, after a rest of %2 s.</source>
        <translation>Als Nächstes: %1, nach %2 s Ruhe.</translation>
    </message>
    <message>
        <source>Next: %1. Press Start.</source>
        <translation>Als Nächstes: %1. Drücken Sie Start.</translation>
    </message>
    <message>
        <source>Setting the zero. Nobody touches the device.</source>
        <translation>Nullabgleich läuft. Niemand berührt das Gerät.</translation>
    </message>
    <message>
        <source>Recording: %1.</source>
        <translation>Aufnahme läuft: %1.</translation>
    </message>
    <message>
        <source>Paused. Resume when the patient is ready.</source>
        <translation>Pause. Machen Sie weiter, wenn der Patient bereit ist.</translation>
    </message>
    <message>
        <source>The recording is over. Disconnect to end the session.</source>
        <translation>Die Aufzeichnung ist zu Ende. Trennen Sie die Verbindung, um die Sitzung zu beenden.</translation>
    </message>
    <message>
        <source>Zero refused: %1</source>
        <translation>Nullabgleich abgelehnt: %1</translation>
    </message>
    <message>
        <source>Device connected. Set the zero with the device empty.</source>
        <translation>Gerät verbunden. Machen Sie den Nullabgleich bei leerem Gerät.</translation>
    </message>
    <message>
        <source>Recording ready. Choose a task and press Start.</source>
        <translation>Aufzeichnung bereit. Wählen Sie eine Aufgabe und drücken Sie Start.</translation>
    </message>
    <message>
        <source>%1 Next: the maximum grip force.</source>
        <translation>%1 Als Nächstes: die maximale Griffkraft.</translation>
    </message>
    <message>
        <source>Resting force is known.</source>
        <translation>Die Ruhekraft ist bekannt.</translation>
    </message>
    <message>
        <source>%1 Repeat it after one minute, or choose a task and press Start.</source>
        <translation>%1 Wiederholen Sie es nach einer Minute oder wählen Sie eine Aufgabe und drücken Sie Start.</translation>
    </message>
    <message>
        <source>%1 Choose a task and press Start.</source>
        <translation>%1 Wählen Sie eine Aufgabe und drücken Sie Start.</translation>
    </message>
    <message>
        <source>Trial stored. Repeat it, choose another task, or disconnect to end.</source>
        <translation>Versuch gespeichert. Wiederholen Sie ihn, wählen Sie eine andere Aufgabe oder trennen Sie die Verbindung.</translation>
    </message>
    <message>
        <source>Opening the database …</source>
        <translation>Die Datenbank wird geöffnet …</translation>
    </message>
    <message>
        <source>Connecting to the device …</source>
        <translation>Verbindung zum Gerät wird hergestellt …</translation>
    </message>
    <message>
        <source>Saving the session …</source>
        <translation>Die Sitzung wird gespeichert …</translation>
    </message>
    <message>
        <source>Choose a patient, or add a new one.</source>
        <translation>Wählen Sie einen Patienten oder legen Sie einen neuen an.</translation>
    </message>
    <message>
        <source>This is not the affected hand. Confirm it, or choose the other.</source>
        <translation>Das ist nicht die betroffene Hand. Bestätigen Sie es oder wählen Sie die andere.</translation>
    </message>
    <message>
        <source>Which hand is in the device today? Choose right or left.</source>
        <translation>Welche Hand ist heute im Gerät? Wählen Sie rechts oder links.</translation>
    </message>
    <message>
        <source>Ask the screening questions before any force.</source>
        <translation>Stellen Sie die Vorab-Fragen, bevor Kraft verlangt wird.</translation>
    </message>
    <message>
        <source>Looking whether this protocol was interrupted today …</source>
        <translation>Es wird gesucht, ob dieses Protokoll heute unterbrochen wurde …</translation>
    </message>
    <message>
        <source>This protocol was interrupted today: go on, or begin anew?</source>
        <translation>Dieses Protokoll wurde heute unterbrochen: fortsetzen oder neu beginnen?</translation>
    </message>
    <message>
        <source>Choose the device.</source>
        <translation>Wählen Sie das Gerät.</translation>
    </message>
    <message>
        <source>Connect the device to begin the session.</source>
        <translation>Verbinden Sie das Gerät, um die Sitzung zu beginnen.</translation>
    </message>
    <message>
        <source>%1 The trial waits; nothing is lost.</source>
        <translation>%1 Der Versuch wartet; nichts geht verloren.</translation>
    </message>
    <message>
        <source>Connect the device first.</source>
        <translation>Verbinden Sie zuerst das Gerät.</translation>
    </message>
    <message>
        <source>The recording is over.</source>
        <translation>Die Aufzeichnung ist zu Ende.</translation>
    </message>
    <message>
        <source>Set the zero first, with the device empty.</source>
        <translation>Machen Sie zuerst den Nullabgleich bei leerem Gerät.</translation>
    </message>
    <message>
        <source>Wait until the zero is set.</source>
        <translation>Warten Sie, bis der Nullabgleich fertig ist.</translation>
    </message>
    <message>
        <source>A trial is running.</source>
        <translation>Ein Versuch läuft.</translation>
    </message>
    <message>
        <source>The protocol is finished.</source>
        <translation>Das Protokoll ist beendet.</translation>
    </message>
    <message>
        <source>Set the zero of the empty device once more.</source>
        <translation>Wiederholen Sie den Nullabgleich des leeren Geräts.</translation>
    </message>
    <message>
        <source>The strapped hand settles: %1 s.</source>
        <translation>Die angegurtete Hand kommt zur Ruhe: %1 s.</translation>
    </message>
    <message>
        <source>Rest: %1 s.</source>
        <translation>Ruhe: %1 s.</translation>
    </message>
    <message>
        <source>The pause is over in a moment.</source>
        <translation>Die Pause ist gleich zu Ende.</translation>
    </message>
    <message>
        <source>Choose a task.</source>
        <translation>Wählen Sie eine Aufgabe.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>Beschäftigt</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>Zu tun</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>The device works again. The hand lets go; if Resume stays closed, stop, set the zero and repeat the trial.</source>
        <translation>Das Gerät arbeitet wieder. Die Hand lässt los; bleibt „Weitermachen“ gesperrt, beenden, Nullabgleich setzen und den Versuch wiederholen.</translation>
    </message>
    <message>
        <source>The straps have been on for 20 minutes: look at the skin, then confirm that the hand is in and strapped.</source>
        <translation>Die Gurte sitzen seit 20 Minuten: Sehen Sie die Haut an und bestätigen Sie dann, dass die Hand angegurtet ist.</translation>
    </message>
    <message>
        <source>%1 Strap the hand in and say so; after a minute the resting force begins.</source>
        <translation>%1 Gurten Sie die Hand an und bestätigen Sie es; nach einer Minute beginnt die Ruhekraft.</translation>
    </message>
    <message>
        <source>Hand strapped. It settles: %1 s, then the resting force begins.</source>
        <translation>Hand angegurtet. Sie kommt zur Ruhe: noch %1 s, dann beginnt die Ruhekraft.</translation>
    </message>
    <message>
        <source>Only to look: another program has this file open. Sessions begin there.</source>
        <translation>Nur zum Ansehen: Ein anderes Programm hat diese Datei geöffnet. Sitzungen beginnen dort.</translation>
    </message>
    <message>
        <source>Next: %1, which cannot be made. Skip it.</source>
        <translation>Als Nächstes: %1, das nicht möglich ist. Lassen Sie es aus.</translation>
    </message>
    <message>
        <source>Zero is set. Strap the hand in again and say so.</source>
        <translation>Der Nullabgleich ist erfolgt. Gurten Sie die Hand wieder an und bestätigen Sie es.</translation>
    </message>
    <message>
        <source>The resting force is not known: choose it first, or go on without it.</source>
        <translation>Die Ruhekraft ist nicht bekannt: Wählen Sie sie zuerst, oder arbeiten Sie ohne sie weiter.</translation>
    </message>
    <message>
        <source>The device sends no more forces. Disconnect to end the session.</source>
        <translation>Das Gerät sendet keine Kräfte mehr. Trennen Sie es, um die Sitzung zu beenden.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Einen Moment …</translation>
    </message>
    <message>
        <source>Say first that the hand is in and strapped.</source>
        <translation>Bestätigen Sie zuerst, dass die Hand angegurtet ist.</translation>
    </message>
</context>
<context>
    <name>LibraryPreview</name>
    <message>
        <source>%1, at most %2</source>
        <translation>%1, höchstens %2</translation>
    </message>
    <message>
        <source>Target (N)</source>
        <translation>Ziel (N)</translation>
    </message>
    <message>
        <source>Target (% of the maximum)</source>
        <translation>Ziel (% des Maximums)</translation>
    </message>
    <message>
        <source>Target (% of the comfortable force)</source>
        <translation>Ziel (% der angenehmen Kraft)</translation>
    </message>
    <message>
        <source>Target (% of the baseline)</source>
        <translation>Ziel (% des Ausgangswerts)</translation>
    </message>
    <message>
        <source>%1 of the target (%2)</source>
        <translation>%1 des Ziels (%2)</translation>
    </message>
    <message>
        <source>maximum: %1</source>
        <translation>Maximum: %1</translation>
    </message>
    <message>
        <source>comfortable force: %1</source>
        <translation>angenehme Kraft: %1</translation>
    </message>
    <message>
        <source>baseline: %1</source>
        <translation>Ausgangswert: %1</translation>
    </message>
    <message>
        <source>The patient reads</source>
        <translation>Der Patient liest</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Measured before</source>
        <translation>Vorher zu messen</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Schwierigkeit</translation>
    </message>
    <message>
        <source>may be chosen or follow success: for training, not assessment</source>
        <translation>wählbar oder dem Erfolg folgend: für Training, nicht für Assessments</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>no set of fingers</source>
        <translation>keine Gruppe von Fingern</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>Held firmly by</source>
        <translation>Fest gehalten von</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bewegt sich</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Dreht sich</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Forces act in</source>
        <translation>Kräfte wirken in</translation>
    </message>
    <message>
        <source>Grasp rule</source>
        <translation>Griffregel</translation>
    </message>
    <message>
        <source>Limits of travel</source>
        <translation>Bewegungsgrenzen</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Rechenaufwand</translation>
    </message>
    <message>
        <source>%1 ns per frame, measured here</source>
        <translation>%1 ns pro Bild, hier gemessen</translation>
    </message>
    <message>
        <source>Instrument zero</source>
        <translation>Nullabgleich des Geräts</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 (%2 to %3 times)</source>
        <translation>%1 (%2- bis %3-mal)</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n time(s))</source>
        <translation>
            <numerusform>%1 (%n-mal)</numerusform>
            <numerusform>%1 (%n-mal)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1, Übung</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
</context>
<context>
    <name>NextWords</name>
    <message>
        <source>%1, practice</source>
        <translation>%1, Übung</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>PatientScreen</name>
    <message>
        <source>Thumb and index</source>
        <translation>Daumen und Zeigefinger</translation>
    </message>
    <message>
        <source>Thumb</source>
        <translation>Daumen</translation>
    </message>
    <message>
        <source>Index finger</source>
        <translation>Zeigefinger</translation>
    </message>
    <message>
        <source>Middle finger</source>
        <translation>Mittelfinger</translation>
    </message>
    <message>
        <source>All fingers</source>
        <translation>Alle Finger</translation>
    </message>
    <message>
        <source>Pinch: thumb and index</source>
        <translation>Daumen und Zeigefinger drücken</translation>
    </message>
    <message>
        <source>Press with all fingers</source>
        <translation>Mit allen Fingern drücken</translation>
    </message>
    <message>
        <source>Press with the thumb only</source>
        <translation>Nur mit dem Daumen drücken</translation>
    </message>
    <message>
        <source>Press with the index finger only</source>
        <translation>Nur mit dem Zeigefinger drücken</translation>
    </message>
    <message>
        <source>Press with the middle finger only</source>
        <translation>Nur mit dem Mittelfinger drücken</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Open your hand</source>
        <translation>Hand öffnen</translation>
    </message>
    <message>
        <source>Open thumb and index</source>
        <translation>Daumen und Zeigefinger öffnen</translation>
    </message>
    <message>
        <source>%1: pull back</source>
        <translation>%1: abheben</translation>
    </message>
    <message>
        <source>%1: pull toward you</source>
        <translation>%1: zu sich ziehen</translation>
    </message>
    <message>
        <source>%1: push away</source>
        <translation>%1: wegschieben</translation>
    </message>
    <message>
        <source>Thumb toward you, index away</source>
        <translation>Daumen zu sich, Zeigefinger weg</translation>
    </message>
    <message>
        <source>Thumb away, index toward you</source>
        <translation>Daumen weg, Zeigefinger zu sich</translation>
    </message>
    <message>
        <source>Thumb toward you, fingers away</source>
        <translation>Daumen zu sich, Finger weg</translation>
    </message>
    <message>
        <source>Thumb away, fingers toward you</source>
        <translation>Daumen weg, Finger zu sich</translation>
    </message>
    <message>
        <source>%1: push up</source>
        <translation>%1: nach oben schieben</translation>
    </message>
    <message>
        <source>%1: push down</source>
        <translation>%1: nach unten schieben</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Take your hand out</source>
        <translation>Hand herausnehmen</translation>
    </message>
    <message>
        <source>Please take it out of the device.</source>
        <translation>Bitte nehmen Sie sie aus dem Gerät.</translation>
    </message>
    <message>
        <source>Let your hand rest</source>
        <translation>Hand ruhen lassen</translation>
    </message>
    <message>
        <source>Do nothing. Breathe calmly.</source>
        <translation>Nichts tun. Ruhig atmen.</translation>
    </message>
    <message>
        <source>%1!</source>
        <translation>%1!</translation>
    </message>
    <message>
        <source>As hard as you can. Breathe out.</source>
        <translation>So fest Sie können. Ausatmen.</translation>
    </message>
    <message>
        <source>Squeeze comfortably</source>
        <translation>Angenehm drücken</translation>
    </message>
    <message>
        <source>Hold it. Breathe calmly.</source>
        <translation>Halten. Ruhig atmen.</translation>
    </message>
    <message>
        <source>Press comfortably</source>
        <translation>Angenehm drücken</translation>
    </message>
    <message>
        <source>Open comfortably</source>
        <translation>Angenehm öffnen</translation>
    </message>
    <message>
        <source>Push comfortably</source>
        <translation>Angenehm schieben</translation>
    </message>
    <message>
        <source>Follow the line</source>
        <translation>Der Linie folgen</translation>
    </message>
    <message>
        <source>Squeeze harder: the dot goes up</source>
        <translation>Fester drücken: der Punkt steigt</translation>
    </message>
    <message>
        <source>Keep the dot on the line</source>
        <translation>Den Punkt auf der Linie halten</translation>
    </message>
    <message>
        <source>The same force again</source>
        <translation>Noch einmal dieselbe Kraft</translation>
    </message>
    <message>
        <source>Without looking, as before.</source>
        <translation>Ohne Anzeige, wie vorher.</translation>
    </message>
    <message>
        <source>Let go!</source>
        <translation>Loslassen!</translation>
    </message>
    <message>
        <source>As fast as you can.</source>
        <translation>So schnell Sie können.</translation>
    </message>
    <message>
        <source>Bring it to the outline</source>
        <translation>In den Umriss bringen</translation>
    </message>
    <message>
        <source>Slowly and level</source>
        <translation>Langsam und gerade</translation>
    </message>
    <message>
        <source>Disc into the ring, same size</source>
        <translation>Scheibe in den Ring, gleich groß</translation>
    </message>
    <message>
        <source>%1: fill the ring</source>
        <translation>%1: den Ring füllen</translation>
    </message>
    <message>
        <source>Fill every ring</source>
        <translation>Alle Ringe füllen</translation>
    </message>
    <message>
        <source>Stay on the outline</source>
        <translation>Auf dem Umriss bleiben</translation>
    </message>
    <message>
        <source>It moves: go with it</source>
        <translation>Er bewegt sich: mitgehen</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>Leave it there</source>
        <translation>Dort stehen lassen</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>Halten Sie still</translation>
    </message>
    <message>
        <source>Until the ring is full</source>
        <translation>Bis der Ring voll ist</translation>
    </message>
    <message>
        <source>Take it and carry it there</source>
        <translation>Greifen und dorthin tragen</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Als Nächstes: %1</translation>
    </message>
    <message>
        <source>Get ready</source>
        <translation>Bereit machen</translation>
    </message>
    <message>
        <source>Without seeing your force</source>
        <translation>Ohne die eigene Kraft zu sehen</translation>
    </message>
    <message>
        <source>Hold it and wait for the word</source>
        <translation>Halten und auf das Wort warten</translation>
    </message>
    <message>
        <source>Hold it steady on the line</source>
        <translation>Ruhig auf der Linie halten</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>We will begin in a moment.</source>
        <translation>Wir beginnen gleich.</translation>
    </message>
    <message>
        <source>Hands off, please</source>
        <translation>Bitte nicht berühren</translation>
    </message>
    <message>
        <source>The device measures itself.</source>
        <translation>Das Gerät misst sich selbst.</translation>
    </message>
    <message>
        <source>Well done</source>
        <translation>Gut gemacht</translation>
    </message>
    <message>
        <source>Relax your hand.</source>
        <translation>Hand entspannen.</translation>
    </message>
    <message>
        <source>Please take your hand out of the device</source>
        <translation>Bitte die Hand aus dem Gerät nehmen</translation>
    </message>
    <message>
        <source>Relax your hand</source>
        <translation>Hand entspannen</translation>
    </message>
    <message>
        <source>The next task will begin in a moment.</source>
        <translation>Die nächste Aufgabe beginnt gleich.</translation>
    </message>
    <message>
        <source>The device needs help. You did nothing wrong. Relax your hand.</source>
        <translation>Das Gerät braucht Hilfe. Sie haben nichts falsch gemacht. Entspannen Sie die Hand.</translation>
    </message>
    <message>
        <source>Pause. Relax your hand.</source>
        <translation>Pause. Entspannen Sie die Hand.</translation>
    </message>
    <message>
        <source>Watch how it is done</source>
        <translation>Sehen Sie, wie es geht</translation>
    </message>
    <message>
        <source>Good try</source>
        <translation>Gut versucht</translation>
    </message>
</context>
<context>
    <name>Posture</name>
    <message>
        <source>chair with back</source>
        <translation>Stuhl mit Lehne</translation>
    </message>
    <message>
        <source>wheelchair</source>
        <translation>Rollstuhl</translation>
    </message>
    <message>
        <source>edge of the bed</source>
        <translation>Bettkante</translation>
    </message>
    <message>
        <source>in bed</source>
        <translation>im Bett</translation>
    </message>
    <message>
        <source>on the table</source>
        <translation>auf dem Tisch</translation>
    </message>
    <message>
        <source>in a trough</source>
        <translation>in einer Schale</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>neutral</source>
        <translation>neutral</translation>
    </message>
    <message>
        <source>extended</source>
        <translation>gestreckt</translation>
    </message>
    <message>
        <source>flexed</source>
        <translation>gebeugt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>wrist splint</source>
        <translation>Handgelenkschiene</translation>
    </message>
    <message>
        <source>hand splint</source>
        <translation>Handschiene</translation>
    </message>
    <message>
        <source>another one</source>
        <translation>eine andere</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Ellbogen</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Unterarm</translation>
    </message>
    <message>
        <source>Wrist</source>
        <translation>Handgelenk</translation>
    </message>
    <message>
        <source>Orthosis</source>
        <translation>Orthese</translation>
    </message>
    <message>
        <source>Supports at</source>
        <translation>Auflagen bei</translation>
    </message>
    <message>
        <source>Straps at</source>
        <translation>Gurte bei</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1: %2 statt %3</translation>
    </message>
</context>
<context>
    <name>Presentation</name>
    <message>
        <source>left half</source>
        <translation>linke Hälfte</translation>
    </message>
    <message>
        <source>right half</source>
        <translation>rechte Hälfte</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>sounds</source>
        <translation>Töne</translation>
    </message>
    <message>
        <source>force heard</source>
        <translation>Kraft hörbar</translation>
    </message>
    <message>
        <source>spoken</source>
        <translation>gesprochen</translation>
    </message>
</context>
<context>
    <name>Profile</name>
    <message>
        <source>Give year, month and day, such as %1.</source>
        <translation>Geben Sie Tag, Monat und Jahr an, zum Beispiel %1.</translation>
    </message>
    <message>
        <source>“%1” is no day of the calendar. Give year, month and day, such as %2.</source>
        <translation>„%1“ ist kein Tag des Kalenders. Geben Sie Tag, Monat und Jahr an, zum Beispiel %2.</translation>
    </message>
    <message>
        <source>The year of “%1” cannot be right: it is not between %2 and %3.</source>
        <translation>Das Jahr von „%1“ kann nicht stimmen: Es liegt nicht zwischen %2 und %3.</translation>
    </message>
    <message>
        <source>%1 has not come yet.</source>
        <translation>Der %1 liegt in der Zukunft.</translation>
    </message>
    <message>
        <source>Give the score.</source>
        <translation>Geben Sie den Wert an.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 is not possible. %2.</source>
        <translation>%1 ist nicht möglich. %2.</translation>
    </message>
    <message>
        <source>The onset is today.</source>
        <translation>Der Krankheitsbeginn ist heute.</translation>
    </message>
    <message>
        <source>1 day since the onset.</source>
        <translation>1 Tag seit Krankheitsbeginn.</translation>
    </message>
    <message>
        <source>%1 days since the onset.</source>
        <translation>%1 Tage seit Krankheitsbeginn.</translation>
    </message>
    <message>
        <source>Botulinum toxin</source>
        <translation>Botulinumtoxin</translation>
    </message>
    <message>
        <source>Drug</source>
        <translation>Medikament</translation>
    </message>
    <message>
        <source>Orthosis</source>
        <translation>Orthese</translation>
    </message>
    <message>
        <source>Therapy</source>
        <translation>Therapie</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>Action Research Arm Test</source>
        <translation>Action Research Arm Test</translation>
    </message>
    <message>
        <source>Fugl-Meyer Assessment, arm and hand</source>
        <translation>Fugl-Meyer-Assessment, Arm und Hand</translation>
    </message>
    <message>
        <source>Box and Block Test</source>
        <translation>Box-and-Block-Test</translation>
    </message>
    <message>
        <source>Nine-Hole Peg Test</source>
        <translation>Nine-Hole-Peg-Test</translation>
    </message>
    <message>
        <source>Motor Activity Log</source>
        <translation>Motor Activity Log</translation>
    </message>
    <message>
        <source>Modified Ashworth Scale</source>
        <translation>Modifizierte Ashworth-Skala</translation>
    </message>
    <message>
        <source>Sensation, as your clinic counts it</source>
        <translation>Sensibilität, wie Ihre Klinik sie zählt</translation>
    </message>
    <message>
        <source>%1: any number</source>
        <translation>%1: jede Zahl</translation>
    </message>
    <message>
        <source>%1: more than %2 seconds</source>
        <translation>%1: mehr als %2 Sekunden</translation>
    </message>
    <message>
        <source>%1: %2 blocks or more</source>
        <translation>%1: %2 Blöcke oder mehr</translation>
    </message>
    <message>
        <source>%1: %2 to %3</source>
        <translation>%1: %2 bis %3</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 blocks</source>
        <translation>%1 Blöcke</translation>
    </message>
</context>
<context>
    <name>ProtocolGuide</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Zero, device empty</source>
        <translation>Nullabgleich, Gerät leer</translation>
    </message>
    <message>
        <source>Pause, %1 s</source>
        <translation>Pause, %1 s</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1  (n %2)</source>
        <translation>%1  (n %2)</translation>
    </message>
    <message>
        <source>Mean of %1.</source>
        <translation>Mittelwert, %1.</translation>
    </message>
    <message>
        <source>Mean of %1; without a value: %2.</source>
        <translation>Mittelwert, %1; ohne Wert: %2.</translation>
    </message>
    <message>
        <source>%1: choose with the arrow keys (%2)</source>
        <translation>%1: mit den Pfeiltasten wählen (%2)</translation>
    </message>
    <message>
        <source>single tasks</source>
        <translation>einzelne Aufgaben</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nr. %1</translation>
    </message>
    <message>
        <source>%1 not completed</source>
        <translation>%1 unvollständig</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>zero drifted</source>
        <translation>Nullpunkt gewandert</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>, simulated</source>
        <translation>, simuliert</translation>
    </message>
    <message>
        <source>Grip  –</source>
        <translation>Griff  –</translation>
    </message>
    <message>
        <source>Grip  &lt;b&gt;%1 N&lt;/b&gt;</source>
        <translation>Griff  &lt;b&gt;%1 N&lt;/b&gt;</translation>
    </message>
    <message>
        <source>There is nothing to replay: %1.</source>
        <translation>Es gibt nichts abzuspielen: %1.</translation>
    </message>
    <message>
        <source>Thumb</source>
        <translation>Daumen</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Zeigefinger</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mittelfinger</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>levels differ</source>
        <translation>Stufen verschieden</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>None of its signals can be shown.</source>
        <translation>Keines seiner Signale kann gezeigt werden.</translation>
    </message>
    <message>
        <source>%1 of its %2 channels can be shown.</source>
        <translation>%1 seiner %2 Kanäle können gezeigt werden.</translation>
    </message>
    <message>
        <source>Its first %1 of %2 samples can be shown.</source>
        <translation>Die ersten %1 von %2 Messwerten können gezeigt werden.</translation>
    </message>
    <message>
        <source>This trial is damaged: %1. %2</source>
        <translation>Dieser Versuch ist beschädigt: %1. %2</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlend</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>Beyond range</source>
        <translation>Außerhalb des Messbereichs</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>torn</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>late</source>
        <translation>verspätet</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>unverändert</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>gesättigt</translation>
    </message>
    <message>
        <source>overloaded</source>
        <translation>überlastet</translation>
    </message>
    <message>
        <source>status errors</source>
        <translation>Statusfehler</translation>
    </message>
    <message>
        <source>restarts</source>
        <translation>Neustarts</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Bus: %1 frames lost</source>
        <translation>Bus: %1 Telegramme verloren</translation>
    </message>
    <message>
        <source>Sensors and bus</source>
        <translation>Sensoren und Bus</translation>
    </message>
    <message>
        <source>nothing to report</source>
        <translation>nichts zu melden</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Counts as</source>
        <translation>Zählt als</translation>
    </message>
    <message>
        <source>helped: no assessment</source>
        <translation>mit Hilfe: kein Assessment</translation>
    </message>
    <message>
        <source>practice: no assessment</source>
        <translation>Übung: kein Assessment</translation>
    </message>
    <message>
        <source>assessment</source>
        <translation>Assessment</translation>
    </message>
    <message>
        <source>no assessment</source>
        <translation>kein Assessment</translation>
    </message>
    <message>
        <source>Task version</source>
        <translation>Version der Aufgabe</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Maximum force</source>
        <translation>Maximalkraft</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullabgleich</translation>
    </message>
    <message>
        <source>none in force</source>
        <translation>keiner gültig</translation>
    </message>
    <message>
        <source>Zero drift</source>
        <translation>Wandern des Nullpunkts</translation>
    </message>
    <message>
        <source>%1 N: the forces are in doubt</source>
        <translation>%1 N: Die Kräfte sind zweifelhaft</translation>
    </message>
    <message>
        <source>not known: no zero followed</source>
        <translation>nicht bekannt: kein Nullabgleich danach</translation>
    </message>
    <message>
        <source>Latest frame</source>
        <translation>Spätestes Bild</translation>
    </message>
    <message>
        <source>%1 ms late</source>
        <translation>%1 ms zu spät</translation>
    </message>
    <message>
        <source>EXAMPLE</source>
        <translation>BEISPIEL</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>AUFZEICHNUNG</translation>
    </message>
    <message>
        <source>1 trial</source>
        <translation>1 Versuch</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 Versuche</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>helped</source>
        <translation>mit Hilfe</translation>
    </message>
    <message>
        <source>1 session</source>
        <translation>1 Sitzung</translation>
    </message>
    <message>
        <source>%1 sessions</source>
        <translation>%1 Sitzungen</translation>
    </message>
    <message>
        <source>%1: year-month-day; Up and Down change it, Enter adds (%2)</source>
        <translation>%1: Tag.Monat.Jahr; Pfeil auf und ab ändern es, Eingabe fügt hinzu (%2)</translation>
    </message>
    <message>
        <source>%1; Enter adds, Ctrl+Z takes back what was typed</source>
        <translation>%1; Eingabe fügt hinzu, Strg+Z nimmt Getipptes zurück</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Enter)</source>
        <translation>%1 (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>Removed: %1, %2.</source>
        <translation>Entfernt: %1, %2.</translation>
    </message>
    <message>
        <source>This is one session twice: choose another one.</source>
        <translation>Das ist zweimal dieselbe Sitzung: Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The two sessions are of different hands.</source>
        <translation>Die beiden Sitzungen gehören zu verschiedenen Händen.</translation>
    </message>
    <message>
        <source>The forces of the two sessions come from different sources.</source>
        <translation>Die Kräfte der beiden Sitzungen kommen aus verschiedenen Quellen.</translation>
    </message>
    <message>
        <source>The two sessions have different frame rates.</source>
        <translation>Die beiden Sitzungen haben verschiedene Abtastraten.</translation>
    </message>
    <message>
        <source>The filter delay of the device differs between the two sessions.</source>
        <translation>Die Filterverzögerung des Geräts unterscheidet sich zwischen den Sitzungen.</translation>
    </message>
    <message>
        <source>other version of the task</source>
        <translation>andere Version der Aufgabe</translation>
    </message>
    <message>
        <source>other parameters or level</source>
        <translation>andere Parameter oder Stufe</translation>
    </message>
    <message>
        <source>other object</source>
        <translation>anderes Objekt</translation>
    </message>
    <message>
        <source>%1, %2: other version of the measure</source>
        <translation>%1, %2: andere Version der Messgröße</translation>
    </message>
    <message>
        <source>Forces and target</source>
        <translation>Kräfte und Ziel</translation>
    </message>
    <message>
        <source>Position of the object</source>
        <translation>Position des Objekts</translation>
    </message>
    <message>
        <source>Angle of the object</source>
        <translation>Winkel des Objekts</translation>
    </message>
    <message>
        <source>Any recorded channel …</source>
        <translation>Beliebiger Kanal …</translation>
    </message>
    <message>
        <source>Task’s force</source>
        <translation>Kraft der Aufgabe</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>no sample</source>
        <translation>kein Messwert</translation>
    </message>
    <message>
        <source>%1 held</source>
        <translation>%1 gehalten</translation>
    </message>
    <message>
        <source>F</source>
        <translation>S</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>R</source>
        <translation>W</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Aborted</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>lead-in, not scored</source>
        <translation>Vorlauf, nicht gewertet</translation>
    </message>
    <message>
        <source>scored</source>
        <translation>gewertet</translation>
    </message>
    <message>
        <source>transport</source>
        <translation>Transport</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1, %2. %3</source>
        <translation>%1, %2. %3</translation>
    </message>
    <message>
        <source>Resting force, %1</source>
        <translation>Ruhekraft, %1</translation>
    </message>
    <message>
        <source>%1 samples left out</source>
        <translation>%1 Messwerte ausgelassen</translation>
    </message>
    <message>
        <source>No forces yet</source>
        <translation>Noch keine Kräfte</translation>
    </message>
    <message>
        <source>   ·   not recorded %1</source>
        <translation>   ·   nicht aufgezeichnet %1</translation>
    </message>
    <message>
        <source>%1: half within %2 ms, 99 % within %3, 99.9 % within %4, longest %5
</source>
        <translation>%1: die Hälfte in %2 ms, 99 % in %3, 99,9 % in %4, längste %5
</translation>
    </message>
    <message>
        <source>From frame to frame</source>
        <translation>Von Bild zu Bild</translation>
    </message>
    <message>
        <source>Late</source>
        <translation>Verspätung</translation>
    </message>
    <message>
        <source>Work on a frame</source>
        <translation>Arbeit an einem Bild</translation>
    </message>
    <message>
        <source>Real time was not asked for</source>
        <translation>Echtzeit war nicht verlangt</translation>
    </message>
    <message>
        <source>Acquisition with %1</source>
        <translation>Erfassung mit %1</translation>
    </message>
    <message>
        <source>Push %1 %</source>
        <translation>Schub %1 %</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>abgeschlossen</translation>
    </message>
    <message>
        <source>stopped early, kept</source>
        <translation>vorzeitig beendet, behalten</translation>
    </message>
    <message>
        <source>interrupted, kept</source>
        <translation>unterbrochen, behalten</translation>
    </message>
    <message>
        <source>There is no display for the patient&apos;s screen.</source>
        <translation>Es gibt keine Anzeige für den Patientenbildschirm.</translation>
    </message>
    <message>
        <source>The patient&apos;s screen needs OpenGL 2.1: install the driver of the graphics card.</source>
        <translation>Der Patientenbildschirm braucht OpenGL 2.1: Installieren Sie den Treiber der Grafikkarte.</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Zählschritte</translation>
    </message>
    <message>
        <source>Frames with gaps %1   ·   lost %2   ·   damaged %3   ·   late %L4 ms, worst %L5 ms</source>
        <translation>Lücken %1   ·   verloren %2   ·   beschädigt %3   ·   verspätet %L4 ms, höchstens %L5 ms</translation>
    </message>
    <message>
        <source>%1 · %2, %3</source>
        <translation>%1 · %2, %3</translation>
    </message>
    <message>
        <source>%1; stays for the next entry (%2)</source>
        <translation>%1; bleibt für den nächsten Eintrag (%2)</translation>
    </message>
    <message>
        <source>Removed: %1.</source>
        <translation>Entfernt: %1.</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>Grip  &lt;b&gt;%1 N, %2 %&lt;/b&gt;</source>
        <translation>Griff  &lt;b&gt;%1 N, %2 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Cannot be judged yet: no assessment yet</source>
        <translation>Noch nicht beurteilbar: noch kein Assessment</translation>
    </message>
    <message>
        <source>Improved (confirmed) · %1</source>
        <translation>Verbessert (bestätigt) · %1</translation>
    </message>
    <message>
        <source>Improved (possible) · %1</source>
        <translation>Verbessert (möglich) · %1</translation>
    </message>
    <message>
        <source>Worsened (confirmed) · %1</source>
        <translation>Verschlechtert (bestätigt) · %1</translation>
    </message>
    <message>
        <source>Worsened (possible) · %1</source>
        <translation>Verschlechtert (möglich) · %1</translation>
    </message>
    <message>
        <source>Not larger than measurement error · %1</source>
        <translation>Nicht größer als der Messfehler · %1</translation>
    </message>
    <message>
        <source>Cannot be judged yet: %1</source>
        <translation>Noch nicht beurteilbar: %1</translation>
    </message>
    <message>
        <source>The measured delay of the display differs between the two sessions.</source>
        <translation>Die gemessene Verzögerung der Anzeige unterscheidet sich zwischen den beiden Sitzungen.</translation>
    </message>
</context>
<context>
    <name>Rescue</name>
    <message>
        <source>The database was taken away while these sessions were recorded. They are kept:</source>
        <translation>Die Datenbank verschwand, während diese Sitzungen aufgezeichnet wurden. Sie sind aufbewahrt:</translation>
    </message>
    <message>
        <source>Take them in with this command:</source>
        <translation>Mit diesem Befehl werden sie aufgenommen:</translation>
    </message>
    <message>
        <source>Take them into the database now?</source>
        <translation>Jetzt in die Datenbank aufnehmen?</translation>
    </message>
</context>
<context>
    <name>Screening</name>
    <message>
        <source>No clearance for maximal effort</source>
        <translation>Keine Freigabe für maximale Kraft</translation>
    </message>
    <message>
        <source>Injury or inflammation of the hand</source>
        <translation>Verletzung, Entzündung der Hand</translation>
    </message>
    <message>
        <source>Broken or numb skin</source>
        <translation>Verletzte oder taube Haut</translation>
    </message>
    <message>
        <source>Botulinum toxin or drug changed</source>
        <translation>Botulinumtoxin, Medikament neu</translation>
    </message>
    <message>
        <source>Seizures</source>
        <translation>Krampfanfälle</translation>
    </message>
    <message>
        <source>Recent haemorrhage or infarct, unstable heart disease, blood pressure at rest above 180/110, aneurysm, recent eye surgery, or nobody has cleared it</source>
        <translation>Frische Blutung oder Infarkt, instabile Herzkrankheit, Ruheblutdruck über 180/110, Aneurysma, frische Augenoperation oder keine ärztliche Freigabe</translation>
    </message>
    <message>
        <source>Fracture, tendon repair, wound, acute arthritis, CRPS</source>
        <translation>Fraktur, Sehnennaht, Wunde, akute Arthritis, CRPS</translation>
    </message>
    <message>
        <source>Under the straps: wounds, pressure marks, no feeling</source>
        <translation>Unter den Gurten: Wunden, Druckstellen, kein Gefühl</translation>
    </message>
    <message>
        <source>Since the last session</source>
        <translation>Seit der letzten Sitzung</translation>
    </message>
    <message>
        <source>In the last year, or known epilepsy</source>
        <translation>Im letzten Jahr oder bekannte Epilepsie</translation>
    </message>
    <message>
        <source>Look at the straps every 20 minutes.</source>
        <translation>Sehen Sie alle 20 Minuten nach den Gurten.</translation>
    </message>
    <message>
        <source>Mark the treatment on the patient&apos;s page.</source>
        <translation>Tragen Sie die Behandlung auf der Seite des Patienten ein.</translation>
    </message>
    <message>
        <source>Stay beside the patient; the straps open with one hand.</source>
        <translation>Bleiben Sie beim Patienten; die Gurte öffnen sich mit einer Hand.</translation>
    </message>
    <message>
        <source>Maximum allowed</source>
        <translation>Maximum erlaubt</translation>
    </message>
    <message>
        <source>Comfortable force only</source>
        <translation>Nur angenehme Kraft</translation>
    </message>
    <message>
        <source>No force</source>
        <translation>Keine Kraft</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>maximal</translation>
    </message>
    <message>
        <source>comfortable</source>
        <translation>angenehm</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>keine Kraft</translation>
    </message>
    <message>
        <source>%1, pain %2</source>
        <translation>%1, Schmerz %2</translation>
    </message>
    <message>
        <source>%1, ≤ %2 N</source>
        <translation>%1, ≤ %2 N</translation>
    </message>
</context>
<context>
    <name>Speaker</name>
    <message>
        <source>This computer has no sound output: connect a loudspeaker, then try again.</source>
        <translation>Dieser Rechner hat keine Tonausgabe: Schließen Sie einen Lautsprecher an und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The sound output does not take 44.1 kHz, 16 bit: choose another one in the settings of the desktop.</source>
        <translation>Die Tonausgabe kann kein 44,1 kHz, 16 bit: Wählen Sie eine andere in den Einstellungen des Desktops.</translation>
    </message>
    <message>
        <source>This computer has no voice: install speech-dispatcher with a voice such as espeak-ng.</source>
        <translation>Dieser Rechner hat keine Stimme: Installieren Sie speech-dispatcher mit einer Stimme wie espeak-ng.</translation>
    </message>
    <message>
        <source>The voice of this computer does not speak %1: install one that does.</source>
        <translation>Die Stimme dieses Rechners spricht kein %1: Installieren Sie eine, die es kann.</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>this folder does not exist</source>
        <translation>diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>choose another folder, or make it first</source>
        <translation>einen anderen Ordner wählen oder ihn zuerst anlegen</translation>
    </message>
    <message>
        <source>this is no folder</source>
        <translation>das ist kein Ordner</translation>
    </message>
    <message>
        <source>nothing may be written into this folder</source>
        <translation>in diesen Ordner darf nichts geschrieben werden</translation>
    </message>
    <message>
        <source>choose another folder, or ask for the permission</source>
        <translation>einen anderen Ordner wählen oder um die Berechtigung bitten</translation>
    </message>
    <message>
        <source>check its number and that of its session</source>
        <translation>seine Nummer und die seiner Sitzung prüfen</translation>
    </message>
    <message>
        <source>correcting a rating</source>
        <translation>Berichtigen einer Einschätzung</translation>
    </message>
    <message>
        <source>rating %1 does not exist</source>
        <translation>Einschätzung %1 gibt es nicht</translation>
    </message>
    <message>
        <source> at %1 %</source>
        <translation> bei %1 %</translation>
    </message>
    <message>
        <source> at %1 Hz</source>
        <translation> bei %1 Hz</translation>
    </message>
    <message>
        <source> at %1 N</source>
        <translation> bei %1 N</translation>
    </message>
    <message>
        <source> of the force</source>
        <translation> der Kraft</translation>
    </message>
    <message>
        <source> target %1</source>
        <translation> Ziel %1</translation>
    </message>
    <message>
        <source>%1 KiB</source>
        <translation>%1 KiB</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source>, all digits</source>
        <translation>, alle Finger</translation>
    </message>
    <message>
        <source>, all digits opening</source>
        <translation>, alle Finger Öffnen</translation>
    </message>
    <message>
        <source>, all digits toward +x</source>
        <translation>, alle Finger Richtung +x</translation>
    </message>
    <message>
        <source>, all digits toward +y</source>
        <translation>, alle Finger Richtung +y</translation>
    </message>
    <message>
        <source>, all digits toward -x</source>
        <translation>, alle Finger Richtung -x</translation>
    </message>
    <message>
        <source>, all digits toward -y</source>
        <translation>, alle Finger Richtung -y</translation>
    </message>
    <message>
        <source>, building up</source>
        <translation>, Aufbau</translation>
    </message>
    <message>
        <source>, grip toward +x</source>
        <translation>, Griff Richtung +x</translation>
    </message>
    <message>
        <source>, grip toward +y</source>
        <translation>, Griff Richtung +y</translation>
    </message>
    <message>
        <source>, grip toward -x</source>
        <translation>, Griff Richtung -x</translation>
    </message>
    <message>
        <source>, grip toward -y</source>
        <translation>, Griff Richtung -y</translation>
    </message>
    <message>
        <source>, holding</source>
        <translation>, Halten</translation>
    </message>
    <message>
        <source>, index</source>
        <translation>, Zeigefinger</translation>
    </message>
    <message>
        <source>, index opening</source>
        <translation>, Zeigefinger Öffnen</translation>
    </message>
    <message>
        <source>, index toward +x</source>
        <translation>, Zeigefinger Richtung +x</translation>
    </message>
    <message>
        <source>, index toward +y</source>
        <translation>, Zeigefinger Richtung +y</translation>
    </message>
    <message>
        <source>, index toward -x</source>
        <translation>, Zeigefinger Richtung -x</translation>
    </message>
    <message>
        <source>, index toward -y</source>
        <translation>, Zeigefinger Richtung -y</translation>
    </message>
    <message>
        <source>, index while middle presses</source>
        <translation>, Zeigefinger, während Mittelfinger drückt</translation>
    </message>
    <message>
        <source>, index while thumb presses</source>
        <translation>, Zeigefinger, während Daumen drückt</translation>
    </message>
    <message>
        <source>, letting down</source>
        <translation>, Nachlassen</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers</source>
        <translation>, Mittel von Daumen und Fingern</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers opening</source>
        <translation>, Mittel von Daumen und Fingern Öffnen</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward +x</source>
        <translation>, Mittel von Daumen und Fingern Richtung +x</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward +y</source>
        <translation>, Mittel von Daumen und Fingern Richtung +y</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward -x</source>
        <translation>, Mittel von Daumen und Fingern Richtung -x</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward -y</source>
        <translation>, Mittel von Daumen und Fingern Richtung -y</translation>
    </message>
    <message>
        <source>, middle</source>
        <translation>, Mittelfinger</translation>
    </message>
    <message>
        <source>, middle opening</source>
        <translation>, Mittelfinger Öffnen</translation>
    </message>
    <message>
        <source>, middle toward +x</source>
        <translation>, Mittelfinger Richtung +x</translation>
    </message>
    <message>
        <source>, middle toward +y</source>
        <translation>, Mittelfinger Richtung +y</translation>
    </message>
    <message>
        <source>, middle toward -x</source>
        <translation>, Mittelfinger Richtung -x</translation>
    </message>
    <message>
        <source>, middle toward -y</source>
        <translation>, Mittelfinger Richtung -y</translation>
    </message>
    <message>
        <source>, middle while index presses</source>
        <translation>, Mittelfinger, während Zeigefinger drückt</translation>
    </message>
    <message>
        <source>, middle while thumb presses</source>
        <translation>, Mittelfinger, während Daumen drückt</translation>
    </message>
    <message>
        <source>, opening</source>
        <translation>, Öffnen</translation>
    </message>
    <message>
        <source>, thumb</source>
        <translation>, Daumen</translation>
    </message>
    <message>
        <source>, thumb and index</source>
        <translation>, Daumen und Zeigefinger</translation>
    </message>
    <message>
        <source>, thumb and index opening</source>
        <translation>, Daumen und Zeigefinger Öffnen</translation>
    </message>
    <message>
        <source>, thumb and index toward +x</source>
        <translation>, Daumen und Zeigefinger Richtung +x</translation>
    </message>
    <message>
        <source>, thumb and index toward +y</source>
        <translation>, Daumen und Zeigefinger Richtung +y</translation>
    </message>
    <message>
        <source>, thumb and index toward -x</source>
        <translation>, Daumen und Zeigefinger Richtung -x</translation>
    </message>
    <message>
        <source>, thumb and index toward -y</source>
        <translation>, Daumen und Zeigefinger Richtung -y</translation>
    </message>
    <message>
        <source>, thumb opening</source>
        <translation>, Daumen Öffnen</translation>
    </message>
    <message>
        <source>, thumb toward +x</source>
        <translation>, Daumen Richtung +x</translation>
    </message>
    <message>
        <source>, thumb toward +y</source>
        <translation>, Daumen Richtung +y</translation>
    </message>
    <message>
        <source>, thumb toward -x</source>
        <translation>, Daumen Richtung -x</translation>
    </message>
    <message>
        <source>, thumb toward -y</source>
        <translation>, Daumen Richtung -y</translation>
    </message>
    <message>
        <source>, thumb while index presses</source>
        <translation>, Daumen, während Zeigefinger drückt</translation>
    </message>
    <message>
        <source>, thumb while middle presses</source>
        <translation>, Daumen, während Mittelfinger drückt</translation>
    </message>
    <message>
        <source>, turn about x</source>
        <translation>, Drehung um x</translation>
    </message>
    <message>
        <source>, turn about y</source>
        <translation>, Drehung um y</translation>
    </message>
    <message>
        <source>, turn about z</source>
        <translation>, Drehung um z</translation>
    </message>
    <message>
        <source>, x</source>
        <translation>, x</translation>
    </message>
    <message>
        <source>, y</source>
        <translation>, y</translation>
    </message>
    <message>
        <source>, z</source>
        <translation>, z</translation>
    </message>
    <message>
        <source>A sensor is not the one that belongs here: do not measure with it.</source>
        <translation>Ein Sensor gehört nicht hierher: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>A sensor is overloaded: take the hand out.</source>
        <translation>Ein Sensor ist überlastet: Nehmen Sie die Hand heraus.</translation>
    </message>
    <message>
        <source>A sensor is silent: check its cable and power.</source>
        <translation>Ein Sensor meldet sich nicht: Prüfen Sie Kabel und Stromversorgung.</translation>
    </message>
    <message>
        <source>A sensor loses samples on the way: check the bus wiring.</source>
        <translation>Ein Sensor verliert Messwerte auf dem Weg: Prüfen Sie die Verkabelung des Busses.</translation>
    </message>
    <message>
        <source>A sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Ein Sensor wiederholt einen Wert: Schalten Sie ihn aus und ein und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>A sensor reports that it is broken: do not measure with it.</source>
        <translation>Ein Sensor meldet, dass er defekt ist: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>A sensor started anew: take the hand out and zero again.</source>
        <translation>Ein Sensor hat neu gestartet: Nehmen Sie die Hand heraus und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>Answers before the cue could be seen</source>
        <translation>Antworten, bevor das Signal zu sehen war</translation>
    </message>
    <message>
        <source>At rest thumb %1, index %2, middle %3 N.</source>
        <translation>In Ruhe Daumen %1, Zeigefinger %2, Mittelfinger %3 N.</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Testbatterie</translation>
    </message>
    <message>
        <source>Battery, core</source>
        <translation>Testbatterie, Kern</translation>
    </message>
    <message>
        <source>Bring the block to its outline as fast as you can and hold it still for a moment.</source>
        <translation>Bringen Sie den Block so schnell Sie können in seinen Umriss und halten Sie ihn einen Moment still.</translation>
    </message>
    <message>
        <source>Bring the block to its outline, slowly and level. Turn it there and hold it still.</source>
        <translation>Bringen Sie den Block langsam und gerade in seinen Umriss. Drehen Sie ihn dort und halten Sie ihn still.</translation>
    </message>
    <message>
        <source>CV of the empty device</source>
        <translation>VK des leeren Geräts</translation>
    </message>
    <message>
        <source>Check that nothing leans on the finger support; if it is free, the sensor may be damaged.</source>
        <translation>Prüfen Sie, dass nichts an der Fingerauflage lehnt; ist sie frei, kann der Sensor beschädigt sein.</translation>
    </message>
    <message>
        <source>Close and open</source>
        <translation>Schließen und öffnen</translation>
    </message>
    <message>
        <source>Closing-opening profile</source>
        <translation>Schließ-Öffnungs-Profil</translation>
    </message>
    <message>
        <source>Comfortable force above rest</source>
        <translation>Angenehme Kraft über Ruhe</translation>
    </message>
    <message>
        <source>Comfortable force, total</source>
        <translation>Angenehme Kraft, gesamt</translation>
    </message>
    <message>
        <source>Comfortable grip above rest</source>
        <translation>Angenehmer Griff über Ruhe</translation>
    </message>
    <message>
        <source>Comfortable grip force</source>
        <translation>Angenehme Griffkraft</translation>
    </message>
    <message>
        <source>Comfortable grip, total</source>
        <translation>Angenehmer Griff, gesamt</translation>
    </message>
    <message>
        <source>Constant error</source>
        <translation>Konstanter Fehler</translation>
    </message>
    <message>
        <source>Correct quaternion_wxyz in the device file.</source>
        <translation>Berichtigen Sie quaternion_wxyz in der Gerätedatei.</translation>
    </message>
    <message>
        <source>Correct quaternion_wxyz or sign in the device file.</source>
        <translation>Berichtigen Sie quaternion_wxyz oder sign in der Gerätedatei.</translation>
    </message>
    <message>
        <source>Coupling of grip and load (virtual)</source>
        <translation>Kopplung von Griff und Last (virtuell)</translation>
    </message>
    <message>
        <source>Cues answered</source>
        <translation>Beantwortete Signale</translation>
    </message>
    <message>
        <source>Cues to let go answered</source>
        <translation>Beantwortete Loslass-Signale</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Demonstration</translation>
    </message>
    <message>
        <source>Detour of the forces</source>
        <translation>Umweg der Kräfte</translation>
    </message>
    <message>
        <source>Detour of the grips</source>
        <translation>Umweg der Griffe</translation>
    </message>
    <message>
        <source>Direction error</source>
        <translation>Richtungsfehler</translation>
    </message>
    <message>
        <source>Directness of the path</source>
        <translation>Geradheit des Wegs</translation>
    </message>
    <message>
        <source>Distance outside the corridor (RMS)</source>
        <translation>Abstand außerhalb des Korridors (RMS)</translation>
    </message>
    <message>
        <source>Distance outside the corridor (mean)</source>
        <translation>Abstand außerhalb des Korridors (Mittel)</translation>
    </message>
    <message>
        <source>Do not measure with it: have it calibrated.</source>
        <translation>Messen Sie nicht damit: Lassen Sie ihn kalibrieren.</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Fallengelassen</translation>
    </message>
    <message>
        <source>Elastic block</source>
        <translation>Elastischer Block</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Ausdauer</translation>
    </message>
    <message>
        <source>Error of the force from memory</source>
        <translation>Fehler der Kraft aus dem Gedächtnis</translation>
    </message>
    <message>
        <source>Error of the grip from memory</source>
        <translation>Fehler des Griffs aus dem Gedächtnis</translation>
    </message>
    <message>
        <source>Exchange their cables or their entries in the device file.</source>
        <translation>Tauschen Sie ihre Kabel oder ihre Einträge in der Gerätedatei.</translation>
    </message>
    <message>
        <source>Fading of the force</source>
        <translation>Nachlassen der Kraft</translation>
    </message>
    <message>
        <source>Fading of the grip</source>
        <translation>Nachlassen des Griffs</translation>
    </message>
    <message>
        <source>Fall of the held force</source>
        <translation>Abfall der gehaltenen Kraft</translation>
    </message>
    <message>
        <source>Fall of the held grip</source>
        <translation>Abfall des gehaltenen Griffs</translation>
    </message>
    <message>
        <source>Familiarisation</source>
        <translation>Eingewöhnung</translation>
    </message>
    <message>
        <source>Fastest release</source>
        <translation>Schnellstes Loslassen</translation>
    </message>
    <message>
        <source>Fastest rise of force</source>
        <translation>Schnellster Kraftanstieg</translation>
    </message>
    <message>
        <source>Fastest rise of grip</source>
        <translation>Schnellster Griffanstieg</translation>
    </message>
    <message>
        <source>Fatigue</source>
        <translation>Ermüdung</translation>
    </message>
    <message>
        <source>Feel this force. Then make the same force again without seeing it.</source>
        <translation>Fühlen Sie diese Kraft. Drücken Sie dann noch einmal gleich stark, ohne es zu sehen.</translation>
    </message>
    <message>
        <source>Follow and turn</source>
        <translation>Folgen und drehen</translation>
    </message>
    <message>
        <source>Follow sideways</source>
        <translation>Seitlich folgen</translation>
    </message>
    <message>
        <source>Follow the arrow: press, pull or push sideways as hard as you can, then relax.</source>
        <translation>Folgen Sie dem Pfeil: Drücken, ziehen oder schieben Sie so fest Sie können, dann entspannen.</translation>
    </message>
    <message>
        <source>Follow the target up and down, as fast as it jumps.</source>
        <translation>Folgen Sie dem Ziel auf und ab, so schnell es springt.</translation>
    </message>
    <message>
        <source>Force direction</source>
        <translation>Kraftrichtung</translation>
    </message>
    <message>
        <source>Force left 5 s after the cue</source>
        <translation>Restkraft 5 s nach dem Signal</translation>
    </message>
    <message>
        <source>Force of a digit that was not asked</source>
        <translation>Kraft eines nicht geforderten Fingers</translation>
    </message>
    <message>
        <source>Force sense</source>
        <translation>Kraftsinn</translation>
    </message>
    <message>
        <source>Free handling</source>
        <translation>Freies Bewegen</translation>
    </message>
    <message>
        <source>Friction used (virtual)</source>
        <translation>Genutzte Reibung (virtuell)</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Good: the index finger&apos;s support felt %1 N.</source>
        <translation>Gut: Die Auflage des Zeigefingers hat %1 N gespürt.</translation>
    </message>
    <message>
        <source>Good: the middle finger&apos;s support felt %1 N.</source>
        <translation>Gut: Die Auflage des Mittelfingers hat %1 N gespürt.</translation>
    </message>
    <message>
        <source>Good: the thumb&apos;s support felt %1 N.</source>
        <translation>Gut: Die Auflage des Daumens hat %1 N gespürt.</translation>
    </message>
    <message>
        <source>Grip and let go</source>
        <translation>Greifen und loslassen</translation>
    </message>
    <message>
        <source>Grip force, own target</source>
        <translation>Griffkraft, eigenes Ziel</translation>
    </message>
    <message>
        <source>Grip force, ramp</source>
        <translation>Griffkraft, Rampe</translation>
    </message>
    <message>
        <source>Grip force, random, new each time</source>
        <translation>Griffkraft, zufällig, jedes Mal neu</translation>
    </message>
    <message>
        <source>Grip force, random, the same each time</source>
        <translation>Griffkraft, zufällig, jedes Mal gleich</translation>
    </message>
    <message>
        <source>Grip force, rectangle</source>
        <translation>Griffkraft, Rechteck</translation>
    </message>
    <message>
        <source>Grip force, several sines</source>
        <translation>Griffkraft, mehrere Sinus</translation>
    </message>
    <message>
        <source>Grip force, sine</source>
        <translation>Griffkraft, Sinus</translation>
    </message>
    <message>
        <source>Grip force, sine, comfortable</source>
        <translation>Griffkraft, Sinus, angenehm</translation>
    </message>
    <message>
        <source>Grip force, sine, fixed load</source>
        <translation>Griffkraft, Sinus, feste Last</translation>
    </message>
    <message>
        <source>Grip force, sine, short</source>
        <translation>Griffkraft, Sinus, kurz</translation>
    </message>
    <message>
        <source>Grip force, sine, without feedback</source>
        <translation>Griffkraft, Sinus, ohne Rückmeldung</translation>
    </message>
    <message>
        <source>Grip force, swept sine</source>
        <translation>Griffkraft, Sinus-Sweep</translation>
    </message>
    <message>
        <source>Grip force, trapezoid</source>
        <translation>Griffkraft, Trapez</translation>
    </message>
    <message>
        <source>Grip force, triangle</source>
        <translation>Griffkraft, Dreieck</translation>
    </message>
    <message>
        <source>Grip per load (virtual)</source>
        <translation>Griff je Last (virtuell)</translation>
    </message>
    <message>
        <source>Grip the block, carry it to its outline, hold it there and let go when told.</source>
        <translation>Greifen Sie den Block, tragen Sie ihn in seinen Umriss, halten Sie ihn dort und lassen Sie auf Ansage los.</translation>
    </message>
    <message>
        <source>Grip the weight, lift it to its outline and hold it still there.</source>
        <translation>Greifen Sie das Gewicht, heben Sie es in seinen Umriss und halten Sie es dort still.</translation>
    </message>
    <message>
        <source>Grip training, sine</source>
        <translation>Grifftraining, Sinus</translation>
    </message>
    <message>
        <source>Hardest effort, of the maximum force</source>
        <translation>Größte Anstrengung, von der Maximalkraft</translation>
    </message>
    <message>
        <source>Hardest effort, of the maximum grip</source>
        <translation>Größte Anstrengung, vom Maximalgriff</translation>
    </message>
    <message>
        <source>Hold error, angle</source>
        <translation>Haltefehler, Winkel</translation>
    </message>
    <message>
        <source>Hold error, main axis</source>
        <translation>Haltefehler, Hauptachse</translation>
    </message>
    <message>
        <source>Hold error, position</source>
        <translation>Haltefehler, Position</translation>
    </message>
    <message>
        <source>Hold the line as long as it stays, up to half a minute.</source>
        <translation>Halten Sie die Linie, solange sie bleibt, bis zu einer halben Minute.</translation>
    </message>
    <message>
        <source>Hold the target. When the screen says let go: let go at once.</source>
        <translation>Halten Sie das Ziel. Wenn der Bildschirm „Loslassen“ sagt: sofort loslassen.</translation>
    </message>
    <message>
        <source>Hold the target. When the screen says open: open your hand at once.</source>
        <translation>Halten Sie das Ziel. Wenn der Bildschirm „Hand öffnen“ sagt: sofort die Hand öffnen.</translation>
    </message>
    <message>
        <source>If nothing leans on the supports, the sensor may be damaged.</source>
        <translation>Wenn nichts an den Auflagen lehnt, kann der Sensor beschädigt sein.</translation>
    </message>
    <message>
        <source>If the device was serviced or remounted since, confirm that.</source>
        <translation>Wenn das Gerät seither gewartet oder umgebaut wurde, bestätigen Sie das.</translation>
    </message>
    <message>
        <source>Impulse of the grip</source>
        <translation>Impuls des Griffs</translation>
    </message>
    <message>
        <source>Index finger, sine</source>
        <translation>Zeigefinger, Sinus</translation>
    </message>
    <message>
        <source>Index of difficulty</source>
        <translation>Schwierigkeitsindex</translation>
    </message>
    <message>
        <source>Instrument zero</source>
        <translation>Nullabgleich des Geräts</translation>
    </message>
    <message>
        <source>It differs from the last empty zero by %1 N; confirmed as serviced or remounted.</source>
        <translation>Er weicht um %1 N vom letzten Nullabgleich bei leerem Gerät ab; als gewartet oder umgebaut bestätigt.</translation>
    </message>
    <message>
        <source>It is kept as it is and never subtracted.</source>
        <translation>Sie bleibt, wie sie ist, und wird nie abgezogen.</translation>
    </message>
    <message>
        <source>It was the index finger&apos;s support that felt this: the sensors of middle and index are swapped.</source>
        <translation>Gespürt hat es die Auflage des Zeigefingers: Die Sensoren von Mittelfinger und Zeigefinger sind vertauscht.</translation>
    </message>
    <message>
        <source>It was the index finger&apos;s support that felt this: the sensors of thumb and index are swapped.</source>
        <translation>Gespürt hat es die Auflage des Zeigefingers: Die Sensoren von Daumen und Zeigefinger sind vertauscht.</translation>
    </message>
    <message>
        <source>It was the middle finger&apos;s support that felt this: the sensors of index and middle are swapped.</source>
        <translation>Gespürt hat es die Auflage des Mittelfingers: Die Sensoren von Zeigefinger und Mittelfinger sind vertauscht.</translation>
    </message>
    <message>
        <source>It was the middle finger&apos;s support that felt this: the sensors of thumb and middle are swapped.</source>
        <translation>Gespürt hat es die Auflage des Mittelfingers: Die Sensoren von Daumen und Mittelfinger sind vertauscht.</translation>
    </message>
    <message>
        <source>It was the thumb&apos;s support that felt this: the sensors of index and thumb are swapped.</source>
        <translation>Gespürt hat es die Auflage des Daumens: Die Sensoren von Zeigefinger und Daumen sind vertauscht.</translation>
    </message>
    <message>
        <source>It was the thumb&apos;s support that felt this: the sensors of middle and thumb are swapped.</source>
        <translation>Gespürt hat es die Auflage des Daumens: Die Sensoren von Mittelfinger und Daumen sind vertauscht.</translation>
    </message>
    <message>
        <source>Jumping target</source>
        <translation>Springendes Ziel</translation>
    </message>
    <message>
        <source>Lag behind the target</source>
        <translation>Rückstand hinter dem Ziel</translation>
    </message>
    <message>
        <source>Lag from the phase</source>
        <translation>Rückstand aus der Phase</translation>
    </message>
    <message>
        <source>Lag of the grip behind the load</source>
        <translation>Rückstand des Griffs hinter der Last</translation>
    </message>
    <message>
        <source>Lag without the device&apos;s delay</source>
        <translation>Rückstand ohne Verzögerung des Geräts</translation>
    </message>
    <message>
        <source>Learning study</source>
        <translation>Lernstudie</translation>
    </message>
    <message>
        <source>Leave your hand in the device. Let it rest. Do nothing.</source>
        <translation>Lassen Sie die Hand im Gerät. Lassen Sie sie ruhen. Tun Sie nichts.</translation>
    </message>
    <message>
        <source>Let go, short</source>
        <translation>Loslassen, kurz</translation>
    </message>
    <message>
        <source>Lift a weight</source>
        <translation>Ein Gewicht heben</translation>
    </message>
    <message>
        <source>Maximum force above rest</source>
        <translation>Maximalkraft über Ruhe</translation>
    </message>
    <message>
        <source>Maximum force, index finger</source>
        <translation>Maximalkraft, Zeigefinger</translation>
    </message>
    <message>
        <source>Maximum force, mean over a fixed window</source>
        <translation>Maximalkraft, Mittel über ein festes Fenster</translation>
    </message>
    <message>
        <source>Maximum force, middle finger</source>
        <translation>Maximalkraft, Mittelfinger</translation>
    </message>
    <message>
        <source>Maximum force, thumb</source>
        <translation>Maximalkraft, Daumen</translation>
    </message>
    <message>
        <source>Maximum force, total</source>
        <translation>Maximalkraft, gesamt</translation>
    </message>
    <message>
        <source>Maximum grip above rest</source>
        <translation>Maximaler Griff über Ruhe</translation>
    </message>
    <message>
        <source>Maximum grip force</source>
        <translation>Maximale Griffkraft</translation>
    </message>
    <message>
        <source>Maximum grip, mean over a fixed window</source>
        <translation>Maximaler Griff, Mittel über ein festes Fenster</translation>
    </message>
    <message>
        <source>Maximum grip, total</source>
        <translation>Maximaler Griff, gesamt</translation>
    </message>
    <message>
        <source>Maximum pinch force</source>
        <translation>Maximale Pinzettenkraft</translation>
    </message>
    <message>
        <source>Mean force</source>
        <translation>Mittlere Kraft</translation>
    </message>
    <message>
        <source>Mean grip</source>
        <translation>Mittlerer Griff</translation>
    </message>
    <message>
        <source>Mean length of a pause</source>
        <translation>Mittlere Länge einer Pause</translation>
    </message>
    <message>
        <source>Mean time, misses at the limit</source>
        <translation>Mittlere Zeit, Verfehltes am Limit</translation>
    </message>
    <message>
        <source>Median time to reach</source>
        <translation>Mediane Zeit bis zum Ziel</translation>
    </message>
    <message>
        <source>Move the block as you like.</source>
        <translation>Bewegen Sie den Block, wie Sie möchten.</translation>
    </message>
    <message>
        <source>No sensor felt a press.</source>
        <translation>Kein Sensor hat einen Druck gespürt.</translation>
    </message>
    <message>
        <source>Open on cue</source>
        <translation>Öffnen auf Signal</translation>
    </message>
    <message>
        <source>Opening force</source>
        <translation>Öffnungskraft</translation>
    </message>
    <message>
        <source>Opening force, index finger</source>
        <translation>Öffnungskraft, Zeigefinger</translation>
    </message>
    <message>
        <source>Opening force, middle finger</source>
        <translation>Öffnungskraft, Mittelfinger</translation>
    </message>
    <message>
        <source>Opening force, thumb</source>
        <translation>Öffnungskraft, Daumen</translation>
    </message>
    <message>
        <source>Opening grip</source>
        <translation>Öffnungsgriff</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Pain %1 of %2, %3 more than at first: stop the work of this hand for today.</source>
        <translation>Schmerz %1 von %2, %3 mehr als zu Beginn: Beenden Sie die Arbeit mit dieser Hand für heute.</translation>
    </message>
    <message>
        <source>Pain %1 of %2: stop the work of this hand for today.</source>
        <translation>Schmerz %1 von %2: Beenden Sie die Arbeit mit dieser Hand für heute.</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Weglänge</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Paused by the therapist.</source>
        <translation>Vom Therapeuten angehalten.</translation>
    </message>
    <message>
        <source>Paused: samples are missing. Check the cables, check the zero, then resume.</source>
        <translation>Angehalten: Messwerte fehlen. Prüfen Sie die Kabel und den Nullabgleich, dann machen Sie weiter.</translation>
    </message>
    <message>
        <source>Paused: the device has a fault. Mend it, check the zero, then resume.</source>
        <translation>Angehalten: Das Gerät hat eine Störung. Beheben Sie sie, prüfen Sie den Nullabgleich, dann machen Sie weiter.</translation>
    </message>
    <message>
        <source>Pauses on the ramp</source>
        <translation>Pausen auf der Rampe</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>Peak grip</source>
        <translation>Spitzengriff</translation>
    </message>
    <message>
        <source>Phase of the answer</source>
        <translation>Phase der Antwort</translation>
    </message>
    <message>
        <source>Pick and place</source>
        <translation>Greifen und absetzen</translation>
    </message>
    <message>
        <source>Pinch force, sine</source>
        <translation>Pinzettenkraft, Sinus</translation>
    </message>
    <message>
        <source>Pinch so that your mark stays on the moving target.</source>
        <translation>Drücken Sie mit Daumen und Zeigefinger, sodass Ihre Marke auf dem bewegten Ziel bleibt.</translation>
    </message>
    <message>
        <source>Press as hard as is comfortable, and hold it.</source>
        <translation>Drücken Sie so fest, wie es angenehm ist, und halten Sie das.</translation>
    </message>
    <message>
        <source>Press gently and follow the line. Try it out.</source>
        <translation>Drücken Sie sanft und folgen Sie der Linie. Probieren Sie es aus.</translation>
    </message>
    <message>
        <source>Press in the direction of the arrow, as hard as the ring is large.</source>
        <translation>Drücken Sie in Richtung des Pfeils, so fest, wie der Ring groß ist.</translation>
    </message>
    <message>
        <source>Press slowly harder with the line.</source>
        <translation>Drücken Sie mit der Linie langsam fester.</translation>
    </message>
    <message>
        <source>Press slowly up to the line, hold it, and let go slowly.</source>
        <translation>Drücken Sie langsam bis zur Linie, halten Sie sie und lassen Sie langsam los.</translation>
    </message>
    <message>
        <source>Press so that your mark stays on the moving target.</source>
        <translation>Drücken Sie so, dass Ihre Marke auf dem bewegten Ziel bleibt.</translation>
    </message>
    <message>
        <source>Press so that your mark stays on the target, also when it gets faster.</source>
        <translation>Drücken Sie so, dass Ihre Marke auf dem Ziel bleibt, auch wenn es schneller wird.</translation>
    </message>
    <message>
        <source>Press the index finger&apos;s support more firmly, or check its cable.</source>
        <translation>Drücken Sie die Auflage des Zeigefingers fester oder prüfen Sie ihr Kabel.</translation>
    </message>
    <message>
        <source>Press the index finger&apos;s support straight in and hold.</source>
        <translation>Drücken Sie die Auflage des Zeigefingers gerade hinein und halten Sie.</translation>
    </message>
    <message>
        <source>Press the middle finger&apos;s support more firmly, or check its cable.</source>
        <translation>Drücken Sie die Auflage des Mittelfingers fester oder prüfen Sie ihr Kabel.</translation>
    </message>
    <message>
        <source>Press the middle finger&apos;s support straight in and hold.</source>
        <translation>Drücken Sie die Auflage des Mittelfingers gerade hinein und halten Sie.</translation>
    </message>
    <message>
        <source>Press the thumb&apos;s support more firmly, or check its cable.</source>
        <translation>Drücken Sie die Auflage des Daumens fester oder prüfen Sie ihr Kabel.</translation>
    </message>
    <message>
        <source>Press the thumb&apos;s support straight in and hold.</source>
        <translation>Drücken Sie die Auflage des Daumens gerade hinein und halten Sie.</translation>
    </message>
    <message>
        <source>Press up to the line and hold it as still as you can.</source>
        <translation>Drücken Sie bis zur Linie und halten Sie so ruhig wie möglich.</translation>
    </message>
    <message>
        <source>Press when the line goes up, open your hand when it goes down.</source>
        <translation>Drücken Sie, wenn die Linie steigt; öffnen Sie die Hand, wenn sie fällt.</translation>
    </message>
    <message>
        <source>Press with the digit shown. Keep the others still.</source>
        <translation>Drücken Sie mit dem gezeigten Finger. Halten Sie die anderen still.</translation>
    </message>
    <message>
        <source>Press with the index finger so that your mark stays on the target.</source>
        <translation>Drücken Sie mit dem Zeigefinger so, dass Ihre Marke auf dem Ziel bleibt.</translation>
    </message>
    <message>
        <source>Press with the target. You do not see your own force.</source>
        <translation>Drücken Sie mit dem Ziel. Ihre eigene Kraft sehen Sie nicht.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (index): muscle tone or a tight strap.</source>
        <translation>Drückt trotz Entspannung (Zeigefinger): Muskeltonus oder ein straffer Gurt.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (index, middle): muscle tone or a tight strap.</source>
        <translation>Drückt trotz Entspannung (Zeigefinger, Mittelfinger): Muskeltonus oder ein straffer Gurt.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (middle): muscle tone or a tight strap.</source>
        <translation>Drückt trotz Entspannung (Mittelfinger): Muskeltonus oder ein straffer Gurt.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb): muscle tone or a tight strap.</source>
        <translation>Drückt trotz Entspannung (Daumen): Muskeltonus oder ein straffer Gurt.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb, index): muscle tone or a tight strap.</source>
        <translation>Drückt trotz Entspannung (Daumen, Zeigefinger): Muskeltonus oder ein straffer Gurt.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb, index, middle): muscle tone or a tight strap.</source>
        <translation>Drückt trotz Entspannung (Daumen, Zeigefinger, Mittelfinger): Muskeltonus oder ein straffer Gurt.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb, middle): muscle tone or a tight strap.</source>
        <translation>Drückt trotz Entspannung (Daumen, Mittelfinger): Muskeltonus oder ein straffer Gurt.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (index): look at the strap and the position of the hand.</source>
        <translation>Zieht trotz Entspannung (Zeigefinger): Sehen Sie nach Gurt und Handstellung.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (index, middle): look at the strap and the position of the hand.</source>
        <translation>Zieht trotz Entspannung (Zeigefinger, Mittelfinger): Sehen Sie nach Gurt und Handstellung.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (middle): look at the strap and the position of the hand.</source>
        <translation>Zieht trotz Entspannung (Mittelfinger): Sehen Sie nach Gurt und Handstellung.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb): look at the strap and the position of the hand.</source>
        <translation>Zieht trotz Entspannung (Daumen): Sehen Sie nach Gurt und Handstellung.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb, index): look at the strap and the position of the hand.</source>
        <translation>Zieht trotz Entspannung (Daumen, Zeigefinger): Sehen Sie nach Gurt und Handstellung.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb, index, middle): look at the strap and the position of the hand.</source>
        <translation>Zieht trotz Entspannung (Daumen, Zeigefinger, Mittelfinger): Sehen Sie nach Gurt und Handstellung.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb, middle): look at the strap and the position of the hand.</source>
        <translation>Zieht trotz Entspannung (Daumen, Mittelfinger): Sehen Sie nach Gurt und Handstellung.</translation>
    </message>
    <message>
        <source>Push of the arm</source>
        <translation>Schub des Arms</translation>
    </message>
    <message>
        <source>Push the index finger&apos;s support toward the wrist and hold.</source>
        <translation>Schieben Sie die Auflage des Zeigefingers zum Handgelenk und halten Sie.</translation>
    </message>
    <message>
        <source>Push the index finger&apos;s support upward and hold.</source>
        <translation>Schieben Sie die Auflage des Zeigefingers nach oben und halten Sie.</translation>
    </message>
    <message>
        <source>Push the middle finger&apos;s support toward the wrist and hold.</source>
        <translation>Schieben Sie die Auflage des Mittelfingers zum Handgelenk und halten Sie.</translation>
    </message>
    <message>
        <source>Push the middle finger&apos;s support upward and hold.</source>
        <translation>Schieben Sie die Auflage des Mittelfingers nach oben und halten Sie.</translation>
    </message>
    <message>
        <source>Push the thumb&apos;s support toward the wrist and hold.</source>
        <translation>Schieben Sie die Auflage des Daumens zum Handgelenk und halten Sie.</translation>
    </message>
    <message>
        <source>Push the thumb&apos;s support upward and hold.</source>
        <translation>Schieben Sie die Auflage des Daumens nach oben und halten Sie.</translation>
    </message>
    <message>
        <source>Put the reference weight on the index finger&apos;s support and wait.</source>
        <translation>Legen Sie das Referenzgewicht auf die Auflage des Zeigefingers und warten Sie.</translation>
    </message>
    <message>
        <source>Put the reference weight on the middle finger&apos;s support and wait.</source>
        <translation>Legen Sie das Referenzgewicht auf die Auflage des Mittelfingers und warten Sie.</translation>
    </message>
    <message>
        <source>Put the reference weight on the thumb&apos;s support and wait.</source>
        <translation>Legen Sie das Referenzgewicht auf die Auflage des Daumens und warten Sie.</translation>
    </message>
    <message>
        <source>Reaction time</source>
        <translation>Reaktionszeit</translation>
    </message>
    <message>
        <source>Reaction time without the device&apos;s delay</source>
        <translation>Reaktionszeit ohne Verzögerung des Geräts</translation>
    </message>
    <message>
        <source>Reaction time, misses at the limit</source>
        <translation>Reaktionszeit, Verfehltes am Limit</translation>
    </message>
    <message>
        <source>Recorded handling</source>
        <translation>Aufgezeichnetes Bewegen</translation>
    </message>
    <message>
        <source>Release time</source>
        <translation>Loslasszeit</translation>
    </message>
    <message>
        <source>Release time without the device&apos;s delay</source>
        <translation>Loslasszeit ohne Verzögerung des Geräts</translation>
    </message>
    <message>
        <source>Release time, misses at the limit</source>
        <translation>Loslasszeit, Verfehltes am Limit</translation>
    </message>
    <message>
        <source>Releases completed</source>
        <translation>Vollständig losgelassen</translation>
    </message>
    <message>
        <source>Resting force</source>
        <translation>Ruhekraft</translation>
    </message>
    <message>
        <source>Resting grip</source>
        <translation>Griff in Ruhe</translation>
    </message>
    <message>
        <source>Rhythm of the force</source>
        <translation>Rhythmus der Kraft</translation>
    </message>
    <message>
        <source>Rhythm of the grip</source>
        <translation>Rhythmus des Griffs</translation>
    </message>
    <message>
        <source>Rise of force in the first 0.2 s</source>
        <translation>Kraftanstieg in den ersten 0,2 s</translation>
    </message>
    <message>
        <source>Rise of grip in the first 0.2 s</source>
        <translation>Griffanstieg in den ersten 0,2 s</translation>
    </message>
    <message>
        <source>Rise time, 10 to 90 %</source>
        <translation>Anstiegszeit, 10 bis 90 %</translation>
    </message>
    <message>
        <source>Safety margin (virtual)</source>
        <translation>Sicherheitsreserve (virtuell)</translation>
    </message>
    <message>
        <source>Sample entropy</source>
        <translation>Sample Entropy</translation>
    </message>
    <message>
        <source>Samples are missing: check the cables of the device, then set the zero again.</source>
        <translation>Messwerte fehlen: Prüfen Sie die Kabel des Geräts und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Einschwingzeit</translation>
    </message>
    <message>
        <source>Settling time, misses at the limit</source>
        <translation>Einschwingzeit, Verfehltes am Limit</translation>
    </message>
    <message>
        <source>Share of fast tremor, 8 to 12 Hz</source>
        <translation>Anteil schnellen Tremors, 8 bis 12 Hz</translation>
    </message>
    <message>
        <source>Share of slow correction, 0.5 to 0.8 Hz</source>
        <translation>Anteil langsamer Korrektur, 0,5 bis 0,8 Hz</translation>
    </message>
    <message>
        <source>Share of the force</source>
        <translation>Anteil an der Kraft</translation>
    </message>
    <message>
        <source>Share of the grip</source>
        <translation>Anteil am Griff</translation>
    </message>
    <message>
        <source>Share of tremor, 2 to 8 Hz</source>
        <translation>Anteil des Tremors, 2 bis 8 Hz</translation>
    </message>
    <message>
        <source>Share of very slow wander, 0.1 to 0.3 Hz</source>
        <translation>Anteil sehr langsamen Wanderns, 0,1 bis 0,3 Hz</translation>
    </message>
    <message>
        <source>Short demonstration</source>
        <translation>Kurze Demonstration</translation>
    </message>
    <message>
        <source>Sideways together</source>
        <translation>Seitlich gemeinsam</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Rutschen</translation>
    </message>
    <message>
        <source>Smoothness (SPARC)</source>
        <translation>Glätte (SPARC)</translation>
    </message>
    <message>
        <source>Smoothness (log dimensionless jerk)</source>
        <translation>Glätte (log. dimensionsloser Ruck)</translation>
    </message>
    <message>
        <source>Spread of the force from memory</source>
        <translation>Streuung der Kraft aus dem Gedächtnis</translation>
    </message>
    <message>
        <source>Spread of the grip from memory</source>
        <translation>Streuung des Griffs aus dem Gedächtnis</translation>
    </message>
    <message>
        <source>Spread of the held force</source>
        <translation>Streuung der gehaltenen Kraft</translation>
    </message>
    <message>
        <source>Spread of the held grip</source>
        <translation>Streuung des gehaltenen Griffs</translation>
    </message>
    <message>
        <source>Steadiness</source>
        <translation>Ruhig halten</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Steps that reached 63 %</source>
        <translation>Stufen, die 63 % erreichten</translation>
    </message>
    <message>
        <source>Steps that settled</source>
        <translation>Eingeschwungene Stufen</translation>
    </message>
    <message>
        <source>Stopped after a device fault.</source>
        <translation>Nach einer Gerätestörung beendet.</translation>
    </message>
    <message>
        <source>Stopped by the therapist.</source>
        <translation>Vom Therapeuten beendet.</translation>
    </message>
    <message>
        <source>Synergy of the fingers</source>
        <translation>Synergie der Finger</translation>
    </message>
    <message>
        <source>Synergy of the fingers (z)</source>
        <translation>Synergie der Finger (z)</translation>
    </message>
    <message>
        <source>Take the hand out, let nothing touch the device, and set the zero again.</source>
        <translation>Nehmen Sie die Hand heraus, lassen Sie nichts das Gerät berühren und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>Targets reached</source>
        <translation>Erreichte Ziele</translation>
    </message>
    <message>
        <source>The block springs back. Push it to its outline and hold it still there.</source>
        <translation>Der Block federt zurück. Schieben Sie ihn in seinen Umriss und halten Sie ihn dort still.</translation>
    </message>
    <message>
        <source>The bus adapter or this computer loses frames: close other programs.</source>
        <translation>Der Busadapter oder dieser Rechner verliert Telegramme: Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The bus adapter was unplugged: plug it in again.</source>
        <translation>Der Busadapter wurde abgezogen: Stecken Sie ihn wieder ein.</translation>
    </message>
    <message>
        <source>The bus counts many errors: check cable and termination.</source>
        <translation>Der Bus zählt viele Fehler: Prüfen Sie Kabel und Abschluss.</translation>
    </message>
    <message>
        <source>The bus interface is down: switch it on.</source>
        <translation>Die Busschnittstelle ist aus: Schalten Sie sie ein.</translation>
    </message>
    <message>
        <source>The bus is switched off after errors: check cable and termination.</source>
        <translation>Der Bus ist nach Fehlern abgeschaltet: Prüfen Sie Kabel und Abschluss.</translation>
    </message>
    <message>
        <source>The device works.</source>
        <translation>Das Gerät arbeitet.</translation>
    </message>
    <message>
        <source>The hand was not still: repeat it if the patient can relax more.</source>
        <translation>Die Hand war nicht ruhig: Wiederholen Sie es, wenn der Patient sich mehr entspannen kann.</translation>
    </message>
    <message>
        <source>The harder you push, the faster the block goes. Bring it to its outline, level, and stop there.</source>
        <translation>Je fester Sie schieben, desto schneller wird der Block. Bringen Sie ihn gerade in seinen Umriss und halten Sie dort an.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor is not the one that belongs here: do not measure with it.</source>
        <translation>Der Sensor des Zeigefingers gehört nicht hierher: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor is overloaded: take the hand out.</source>
        <translation>Der Sensor des Zeigefingers ist überlastet: Nehmen Sie die Hand heraus.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor is silent: check its cable and power.</source>
        <translation>Der Sensor des Zeigefingers meldet sich nicht: Prüfen Sie Kabel und Stromversorgung.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor loses samples on the way: check the bus wiring.</source>
        <translation>Der Sensor des Zeigefingers verliert Messwerte auf dem Weg: Prüfen Sie die Verkabelung des Busses.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Der Sensor des Zeigefingers wiederholt einen Wert: Schalten Sie ihn aus und ein und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor reports that it is broken: do not measure with it.</source>
        <translation>Der Sensor des Zeigefingers meldet, dass er defekt ist: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor started anew: take the hand out and zero again.</source>
        <translation>Der Sensor des Zeigefingers hat neu gestartet: Nehmen Sie die Hand heraus und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>The index sensor differs from the last empty zero (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Zeigefingers weicht vom letzten Nullabgleich bei leerem Gerät ab (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The index sensor drifts (%1 N/s, limit %2 N/s).</source>
        <translation>Der Sensor des Zeigefingers driftet (%1 N/s, Grenze %2 N/s).</translation>
    </message>
    <message>
        <source>The index sensor is loaded (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Zeigefingers ist belastet (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The index sensor is not quiet (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Zeigefingers ist nicht ruhig (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The index sensor is not quiet (%1 Nm, limit %2 Nm).</source>
        <translation>Der Sensor des Zeigefingers ist nicht ruhig (%1 Nm, Grenze %2 Nm).</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor is not the one that belongs here: do not measure with it.</source>
        <translation>Der Sensor des Mittelfingers gehört nicht hierher: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor is overloaded: take the hand out.</source>
        <translation>Der Sensor des Mittelfingers ist überlastet: Nehmen Sie die Hand heraus.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor is silent: check its cable and power.</source>
        <translation>Der Sensor des Mittelfingers meldet sich nicht: Prüfen Sie Kabel und Stromversorgung.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor loses samples on the way: check the bus wiring.</source>
        <translation>Der Sensor des Mittelfingers verliert Messwerte auf dem Weg: Prüfen Sie die Verkabelung des Busses.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Der Sensor des Mittelfingers wiederholt einen Wert: Schalten Sie ihn aus und ein und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor reports that it is broken: do not measure with it.</source>
        <translation>Der Sensor des Mittelfingers meldet, dass er defekt ist: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor started anew: take the hand out and zero again.</source>
        <translation>Der Sensor des Mittelfingers hat neu gestartet: Nehmen Sie die Hand heraus und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>The middle sensor differs from the last empty zero (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Mittelfingers weicht vom letzten Nullabgleich bei leerem Gerät ab (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The middle sensor drifts (%1 N/s, limit %2 N/s).</source>
        <translation>Der Sensor des Mittelfingers driftet (%1 N/s, Grenze %2 N/s).</translation>
    </message>
    <message>
        <source>The middle sensor is loaded (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Mittelfingers ist belastet (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The middle sensor is not quiet (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Mittelfingers ist nicht ruhig (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The middle sensor is not quiet (%1 Nm, limit %2 Nm).</source>
        <translation>Der Sensor des Mittelfingers ist nicht ruhig (%1 Nm, Grenze %2 Nm).</translation>
    </message>
    <message>
        <source>The outline jumps to another place. Bring the block there as fast as you can.</source>
        <translation>Der Umriss springt an einen anderen Ort. Bringen Sie den Block so schnell Sie können dorthin.</translation>
    </message>
    <message>
        <source>The outline moves to the left and to the right. Keep the block on it.</source>
        <translation>Der Umriss bewegt sich nach links und rechts. Halten Sie den Block darauf.</translation>
    </message>
    <message>
        <source>The outline wanders and turns. Keep the block on it.</source>
        <translation>Der Umriss wandert und dreht sich. Halten Sie den Block darauf.</translation>
    </message>
    <message>
        <source>The recording ended.</source>
        <translation>Die Aufzeichnung ging zu Ende.</translation>
    </message>
    <message>
        <source>The same of that digit&apos;s maximum</source>
        <translation>Dasselbe vom Maximum dieses Fingers</translation>
    </message>
    <message>
        <source>The sensor under the index finger&apos;s support shows %1 N for a weight of %2 N.</source>
        <translation>Der Sensor unter der Auflage des Zeigefingers zeigt %1 N bei einem Gewicht von %2 N.</translation>
    </message>
    <message>
        <source>The sensor under the index finger&apos;s support shows another direction (%1 N up, %2 N toward the wrist, %3 N in): it is turned.</source>
        <translation>Der Sensor unter der Auflage des Zeigefingers zeigt eine andere Richtung (%1 N nach oben, %2 N zum Handgelenk, %3 N hinein): Er ist verdreht.</translation>
    </message>
    <message>
        <source>The sensor under the index finger&apos;s support shows the opposite direction.</source>
        <translation>Der Sensor unter der Auflage des Zeigefingers zeigt die Gegenrichtung.</translation>
    </message>
    <message>
        <source>The sensor under the middle finger&apos;s support shows %1 N for a weight of %2 N.</source>
        <translation>Der Sensor unter der Auflage des Mittelfingers zeigt %1 N bei einem Gewicht von %2 N.</translation>
    </message>
    <message>
        <source>The sensor under the middle finger&apos;s support shows another direction (%1 N up, %2 N toward the wrist, %3 N in): it is turned.</source>
        <translation>Der Sensor unter der Auflage des Mittelfingers zeigt eine andere Richtung (%1 N nach oben, %2 N zum Handgelenk, %3 N hinein): Er ist verdreht.</translation>
    </message>
    <message>
        <source>The sensor under the middle finger&apos;s support shows the opposite direction.</source>
        <translation>Der Sensor unter der Auflage des Mittelfingers zeigt die Gegenrichtung.</translation>
    </message>
    <message>
        <source>The sensor under the thumb&apos;s support shows %1 N for a weight of %2 N.</source>
        <translation>Der Sensor unter der Auflage des Daumens zeigt %1 N bei einem Gewicht von %2 N.</translation>
    </message>
    <message>
        <source>The sensor under the thumb&apos;s support shows another direction (%1 N up, %2 N toward the wrist, %3 N in): it is turned.</source>
        <translation>Der Sensor unter der Auflage des Daumens zeigt eine andere Richtung (%1 N nach oben, %2 N zum Handgelenk, %3 N hinein): Er ist verdreht.</translation>
    </message>
    <message>
        <source>The sensor under the thumb&apos;s support shows the opposite direction.</source>
        <translation>Der Sensor unter der Auflage des Daumens zeigt die Gegenrichtung.</translation>
    </message>
    <message>
        <source>The session was closed.</source>
        <translation>Die Sitzung wurde geschlossen.</translation>
    </message>
    <message>
        <source>The thumb sensor differs from the last empty zero (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Daumens weicht vom letzten Nullabgleich bei leerem Gerät ab (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The thumb sensor drifts (%1 N/s, limit %2 N/s).</source>
        <translation>Der Sensor des Daumens driftet (%1 N/s, Grenze %2 N/s).</translation>
    </message>
    <message>
        <source>The thumb sensor is loaded (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Daumens ist belastet (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The thumb sensor is not quiet (%1 N, limit %2 N).</source>
        <translation>Der Sensor des Daumens ist nicht ruhig (%1 N, Grenze %2 N).</translation>
    </message>
    <message>
        <source>The thumb sensor is not quiet (%1 Nm, limit %2 Nm).</source>
        <translation>Der Sensor des Daumens ist nicht ruhig (%1 Nm, Grenze %2 Nm).</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor is not the one that belongs here: do not measure with it.</source>
        <translation>Der Sensor des Daumens gehört nicht hierher: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor is overloaded: take the hand out.</source>
        <translation>Der Sensor des Daumens ist überlastet: Nehmen Sie die Hand heraus.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor is silent: check its cable and power.</source>
        <translation>Der Sensor des Daumens meldet sich nicht: Prüfen Sie Kabel und Stromversorgung.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor loses samples on the way: check the bus wiring.</source>
        <translation>Der Sensor des Daumens verliert Messwerte auf dem Weg: Prüfen Sie die Verkabelung des Busses.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Der Sensor des Daumens wiederholt einen Wert: Schalten Sie ihn aus und ein und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor reports that it is broken: do not measure with it.</source>
        <translation>Der Sensor des Daumens meldet, dass er defekt ist: Messen Sie nicht damit.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor started anew: take the hand out and zero again.</source>
        <translation>Der Sensor des Daumens hat neu gestartet: Nehmen Sie die Hand heraus und wiederholen Sie den Nullabgleich.</translation>
    </message>
    <message>
        <source>The zero has drifted by %1 N since the one before: the trials between are marked.</source>
        <translation>Der Nullpunkt ist seit dem vorigen um %1 N gewandert: Die Versuche dazwischen sind gekennzeichnet.</translation>
    </message>
    <message>
        <source>Three-digit individuation</source>
        <translation>Dreifinger-Individuation</translation>
    </message>
    <message>
        <source>Throughput</source>
        <translation>Durchsatz</translation>
    </message>
    <message>
        <source>Thumb against the fingers</source>
        <translation>Daumen gegen die Finger</translation>
    </message>
    <message>
        <source>Tilt in transport</source>
        <translation>Neigung beim Transport</translation>
    </message>
    <message>
        <source>Time in contact</source>
        <translation>Zeit in Kontakt</translation>
    </message>
    <message>
        <source>Time in the corridor</source>
        <translation>Zeit im Korridor</translation>
    </message>
    <message>
        <source>Time on target</source>
        <translation>Zeit im Ziel</translation>
    </message>
    <message>
        <source>Time to 63 % of the step</source>
        <translation>Zeit bis 63 % der Stufe</translation>
    </message>
    <message>
        <source>Time to 63 % of the step, misses at the limit</source>
        <translation>Zeit bis 63 % der Stufe, Verfehltes am Limit</translation>
    </message>
    <message>
        <source>Time to reach</source>
        <translation>Zeit bis zum Ziel</translation>
    </message>
    <message>
        <source>Time until letting go begins</source>
        <translation>Zeit bis zum Beginn des Loslassens</translation>
    </message>
    <message>
        <source>Time until letting go begins, misses at the limit</source>
        <translation>Zeit bis zum Beginn des Loslassens, Verfehltes am Limit</translation>
    </message>
    <message>
        <source>Time until letting go begins, without the device&apos;s delay</source>
        <translation>Zeit bis zum Beginn des Loslassens, ohne Verzögerung des Geräts</translation>
    </message>
    <message>
        <source>Time with a push of more than 20 %</source>
        <translation>Zeit mit mehr als 20 % Schub</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Tracking error (RMS)</source>
        <translation>Folgefehler (RMS)</translation>
    </message>
    <message>
        <source>Tracking error (mean)</source>
        <translation>Folgefehler (Mittel)</translation>
    </message>
    <message>
        <source>Tracking error, relative</source>
        <translation>Folgefehler, relativ</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Turn the knob</source>
        <translation>Den Knopf drehen</translation>
    </message>
    <message>
        <source>Turn the knob to the mark and hold it still there.</source>
        <translation>Drehen Sie den Knopf zur Marke und halten Sie ihn dort still.</translation>
    </message>
    <message>
        <source>Turn the knob to the mark. Stop turning when you are there and hold it still.</source>
        <translation>Drehen Sie den Knopf zur Marke. Hören Sie dort auf zu drehen und halten Sie ihn still.</translation>
    </message>
    <message>
        <source>Turn the knob, rate control</source>
        <translation>Den Knopf drehen, Tempo-Steuerung</translation>
    </message>
    <message>
        <source>Two targets</source>
        <translation>Zwei Ziele</translation>
    </message>
    <message>
        <source>Two targets, long way</source>
        <translation>Zwei Ziele, langer Weg</translation>
    </message>
    <message>
        <source>Two targets, mirrored</source>
        <translation>Zwei Ziele, gespiegelt</translation>
    </message>
    <message>
        <source>Two targets, rate control</source>
        <translation>Zwei Ziele, Tempo-Steuerung</translation>
    </message>
    <message>
        <source>Two targets, training</source>
        <translation>Zwei Ziele, Training</translation>
    </message>
    <message>
        <source>Two targets, weak hand</source>
        <translation>Zwei Ziele, schwache Hand</translation>
    </message>
    <message>
        <source>Unasked force per force asked</source>
        <translation>Nicht geforderte je geforderter Kraft</translation>
    </message>
    <message>
        <source>Unasked grip per force asked</source>
        <translation>Nicht geforderter Griff je geforderter Kraft</translation>
    </message>
    <message>
        <source>Unsteadiness (CV)</source>
        <translation>Unruhe (VK)</translation>
    </message>
    <message>
        <source>Unwanted flexion</source>
        <translation>Ungewollte Beugung</translation>
    </message>
    <message>
        <source>Useful share of the force</source>
        <translation>Nützlicher Anteil der Kraft</translation>
    </message>
    <message>
        <source>Useful share of the grip</source>
        <translation>Nützlicher Anteil des Griffs</translation>
    </message>
    <message>
        <source>Variance that changes the sum</source>
        <translation>Varianz, die die Summe ändert</translation>
    </message>
    <message>
        <source>Variance that leaves the sum alone</source>
        <translation>Varianz, die die Summe lässt</translation>
    </message>
    <message>
        <source>Variation of the grip</source>
        <translation>Schwankung des Griffs</translation>
    </message>
    <message>
        <source>When the screen says so: lift the index finger against the strap, build up, pull, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: Zeigefinger gegen den Gurt abheben, aufbauen, ziehen, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says so: lift the middle finger against the strap, build up, pull, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: Mittelfinger gegen den Gurt abheben, aufbauen, ziehen, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says so: lift the thumb against the strap, build up, pull, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: Daumen gegen den Gurt abheben, aufbauen, ziehen, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says so: open your hand against the straps, build up, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: Hand gegen die Gurte öffnen, aufbauen, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says so: pinch with thumb and index finger, build up, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: mit Daumen und Zeigefinger drücken, aufbauen, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says so: press with the index finger, build up, press hard, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: mit dem Zeigefinger drücken, aufbauen, fest drücken, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says so: press with the middle finger, build up, press hard, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: mit dem Mittelfinger drücken, aufbauen, fest drücken, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says so: press with the thumb, build up, press hard, breathe out, stop.</source>
        <translation>Wenn der Bildschirm es sagt: mit dem Daumen drücken, aufbauen, fest drücken, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the screen says squeeze: build up over one second, squeeze, breathe out, stop.</source>
        <translation>Wenn der Bildschirm „Drücken“ sagt: eine Sekunde lang aufbauen, drücken, ausatmen, aufhören.</translation>
    </message>
    <message>
        <source>When the target jumps, follow it at once and stay on it.</source>
        <translation>Wenn das Ziel springt, folgen Sie ihm sofort und bleiben Sie darauf.</translation>
    </message>
    <message>
        <source>a group of signals has no columns</source>
        <translation>eine Gruppe von Signalen hat keine Spalten</translation>
    </message>
    <message>
        <source>a signal does not vary</source>
        <translation>ein Signal ändert sich nicht</translation>
    </message>
    <message>
        <source>a trial or a zero is still running</source>
        <translation>ein Versuch oder Nullabgleich läuft noch</translation>
    </message>
    <message>
        <source>already there at the cue</source>
        <translation>beim Signal schon dort</translation>
    </message>
    <message>
        <source>checking trial %1</source>
        <translation>Versuch %1 wird geprüft</translation>
    </message>
    <message>
        <source>do not use it: take a backup that you trust</source>
        <translation>verwenden Sie sie nicht: nehmen Sie eine Sicherung, der Sie vertrauen</translation>
    </message>
    <message>
        <source>end it and go on with another one</source>
        <translation>beenden Sie ihn und machen Sie mit einem anderen weiter</translation>
    </message>
    <message>
        <source>fewer than %1 trials</source>
        <translation>weniger als %1 Versuche</translation>
    </message>
    <message>
        <source>fewer than four samples</source>
        <translation>weniger als vier Messwerte</translation>
    </message>
    <message>
        <source>fewer than ten trials</source>
        <translation>weniger als zehn Versuche</translation>
    </message>
    <message>
        <source>fewer than three holds with force</source>
        <translation>weniger als drei Halte mit Kraft</translation>
    </message>
    <message>
        <source>fewer than three samples</source>
        <translation>weniger als drei Messwerte</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>weniger als zwei Messwerte</translation>
    </message>
    <message>
        <source>forces, contacts or utilisation of the fingers are missing</source>
        <translation>Kräfte, Kontakte oder Ausnutzung der Finger fehlen</translation>
    </message>
    <message>
        <source>give at most %1</source>
        <translation>geben Sie höchstens %1 an</translation>
    </message>
    <message>
        <source>grip or load does not vary</source>
        <translation>Griff oder Last ändert sich nicht</translation>
    </message>
    <message>
        <source>higher is better</source>
        <translation>höher ist besser</translation>
    </message>
    <message>
        <source>holds views or computed columns, which isograsp never makes</source>
        <translation>enthält Sichten oder berechnete Spalten, die isograsp nie anlegt</translation>
    </message>
    <message>
        <source>is being written by another program now</source>
        <translation>wird gerade von einem anderen Programm geschrieben</translation>
    </message>
    <message>
        <source>is not a file but a pipe, a socket or a device</source>
        <translation>ist keine Datei, sondern eine Pipe, ein Socket oder ein Gerät</translation>
    </message>
    <message>
        <source>is written, but its folder cannot be synchronised</source>
        <translation>ist geschrieben, aber der Ordner lässt sich nicht mit dem Datenträger abgleichen</translation>
    </message>
    <message>
        <source>it says that it has %1 samples of %2 columns, more than any trial</source>
        <translation>er gibt %1 Werte in %2 Spalten an, mehr als jeder Versuch hat</translation>
    </message>
    <message>
        <source>k of n</source>
        <translation>k von n</translation>
    </message>
    <message>
        <source>less than one whole cycle</source>
        <translation>weniger als ein ganzer Zyklus</translation>
    </message>
    <message>
        <source>less than one whole cycle of the smallest frequency or difference</source>
        <translation>weniger als ein ganzer Zyklus der kleinsten Frequenz oder Differenz</translation>
    </message>
    <message>
        <source>let go before the cue</source>
        <translation>vor dem Signal losgelassen</translation>
    </message>
    <message>
        <source>longer than any trial</source>
        <translation>länger als jeder Versuch</translation>
    </message>
    <message>
        <source>longer than the limit</source>
        <translation>länger als das Limit</translation>
    </message>
    <message>
        <source>lower is better</source>
        <translation>niedriger ist besser</translation>
    </message>
    <message>
        <source>nearer to zero is better</source>
        <translation>näher an null ist besser</translation>
    </message>
    <message>
        <source>no finger touched with friction</source>
        <translation>kein Finger berührte mit Reibung</translation>
    </message>
    <message>
        <source>no force held before the cue</source>
        <translation>vor dem Signal wurde keine Kraft gehalten</translation>
    </message>
    <message>
        <source>no force in this direction</source>
        <translation>keine Kraft in dieser Richtung</translation>
    </message>
    <message>
        <source>no level before the cue</source>
        <translation>keine Stufe vor dem Signal</translation>
    </message>
    <message>
        <source>no more than %1 s of force</source>
        <translation>nicht mehr als %1 s Kraft</translation>
    </message>
    <message>
        <source>no overshoot</source>
        <translation>kein Überschwingen</translation>
    </message>
    <message>
        <source>no pauses</source>
        <translation>keine Pausen</translation>
    </message>
    <message>
        <source>no reaction to the cue</source>
        <translation>keine Reaktion auf das Signal</translation>
    </message>
    <message>
        <source>no repetitions</source>
        <translation>keine Wiederholungen</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>keine Messwerte</translation>
    </message>
    <message>
        <source>no samples after the cue</source>
        <translation>keine Messwerte nach dem Signal</translation>
    </message>
    <message>
        <source>no templates match</source>
        <translation>keine Muster stimmen überein</translation>
    </message>
    <message>
        <source>no uninterrupted window of valid samples is long enough</source>
        <translation>kein lückenloses Fenster gültiger Messwerte ist lang genug</translation>
    </message>
    <message>
        <source>no values</source>
        <translation>keine Werte</translation>
    </message>
    <message>
        <source>nobody has confirmed that the device is empty</source>
        <translation>niemand hat bestätigt, dass das Gerät leer ist</translation>
    </message>
    <message>
        <source>not recorded %1 s after the cue</source>
        <translation>%1 s nach dem Signal nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>not released</source>
        <translation>nicht losgelassen</translation>
    </message>
    <message>
        <source>not settled for %1 s</source>
        <translation>nicht %1 s lang eingeschwungen</translation>
    </message>
    <message>
        <source>nothing is answered at this frequency</source>
        <translation>bei dieser Frequenz kommt keine Antwort</translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation>nichts bewegte sich</translation>
    </message>
    <message>
        <source>nothing was placed</source>
        <translation>nichts wurde abgesetzt</translation>
    </message>
    <message>
        <source>nothing was tried</source>
        <translation>nichts wurde versucht</translation>
    </message>
    <message>
        <source>one repetition only</source>
        <translation>nur eine Wiederholung</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>run the comfortable-force task of it first</source>
        <translation>messen Sie zuerst ihre angenehme Kraft</translation>
    </message>
    <message>
        <source>run the resting-force task and a maximum task of it first</source>
        <translation>messen Sie zuerst die Ruhekraft und ihr Maximum</translation>
    </message>
    <message>
        <source>session %1 of %2</source>
        <translation>Sitzung %1 von %2</translation>
    </message>
    <message>
        <source>shorter than one window of %1 s</source>
        <translation>kürzer als ein Fenster von %1 s</translation>
    </message>
    <message>
        <source>shorter than the lags that are tried</source>
        <translation>kürzer als die geprüften Verschiebungen</translation>
    </message>
    <message>
        <source>take the hand out, let nothing touch the supports, and confirm that</source>
        <translation>nehmen Sie die Hand heraus, lassen Sie nichts die Auflagen berühren und bestätigen Sie das</translation>
    </message>
    <message>
        <source>target or actual does not vary</source>
        <translation>Ziel oder Istwert ändert sich nicht</translation>
    </message>
    <message>
        <source>task %1 of %2</source>
        <translation>Aufgabe %1 von %2</translation>
    </message>
    <message>
        <source>the band has no line of the spectrum</source>
        <translation>das Band enthält keine Linie des Spektrums</translation>
    </message>
    <message>
        <source>the correlation has no peak within %1 s</source>
        <translation>die Korrelation hat kein Maximum innerhalb %1 s</translation>
    </message>
    <message>
        <source>the correlation stays below %1</source>
        <translation>die Korrelation bleibt unter %1</translation>
    </message>
    <message>
        <source>the delay of the device is not known</source>
        <translation>die Verzögerung des Geräts ist nicht bekannt</translation>
    </message>
    <message>
        <source>the delay was not measured and is contained in the raw value</source>
        <translation>die Verzögerung wurde nicht gemessen und steckt im Rohwert</translation>
    </message>
    <message>
        <source>the digits did not press</source>
        <translation>die Finger drückten nicht</translation>
    </message>
    <message>
        <source>the distance is negative</source>
        <translation>der Abstand ist negativ</translation>
    </message>
    <message>
        <source>the end points do not vary</source>
        <translation>die Endpunkte ändern sich nicht</translation>
    </message>
    <message>
        <source>the fingers did not press</source>
        <translation>die Finger drückten nicht</translation>
    </message>
    <message>
        <source>the first %1 s have no force</source>
        <translation>die ersten %1 s haben keine Kraft</translation>
    </message>
    <message>
        <source>the fixed load begins with the second assessment</source>
        <translation>die feste Last beginnt mit dem zweiten Assessment</translation>
    </message>
    <message>
        <source>the force before the cue is not known</source>
        <translation>die Kraft vor dem Signal ist nicht bekannt</translation>
    </message>
    <message>
        <source>the force ends where it began</source>
        <translation>die Kraft endet, wo sie begann</translation>
    </message>
    <message>
        <source>the force never falls</source>
        <translation>die Kraft fällt nie</translation>
    </message>
    <message>
        <source>the force never rises</source>
        <translation>die Kraft steigt nie</translation>
    </message>
    <message>
        <source>the force never rose above rest</source>
        <translation>die Kraft stieg nie über Ruhe</translation>
    </message>
    <message>
        <source>the force stayed above %1 %</source>
        <translation>die Kraft blieb über %1 %</translation>
    </message>
    <message>
        <source>the forces do not vary</source>
        <translation>die Kräfte ändern sich nicht</translation>
    </message>
    <message>
        <source>the hand was strapped less than a minute ago and still settles</source>
        <translation>die Hand wurde vor weniger als einer Minute angegurtet und kommt noch zur Ruhe</translation>
    </message>
    <message>
        <source>the header names %1 columns</source>
        <translation>die Kopfzeile nennt %1 Spalten</translation>
    </message>
    <message>
        <source>the last attempts ended before the limit</source>
        <translation>die letzten Versuche endeten vor dem Limit</translation>
    </message>
    <message>
        <source>the level was not reached</source>
        <translation>die Stufe wurde nicht erreicht</translation>
    </message>
    <message>
        <source>the maximum of the digit is not known</source>
        <translation>das Maximum des Fingers ist nicht bekannt</translation>
    </message>
    <message>
        <source>the mean is not positive</source>
        <translation>der Mittelwert ist nicht positiv</translation>
    </message>
    <message>
        <source>the mean is zero</source>
        <translation>der Mittelwert ist null</translation>
    </message>
    <message>
        <source>the noise of the empty device was not measured</source>
        <translation>das Rauschen des leeren Geräts wurde nicht gemessen</translation>
    </message>
    <message>
        <source>the other digits did not move</source>
        <translation>die anderen Finger bewegten sich nicht</translation>
    </message>
    <message>
        <source>the record ends within %1 s of the onset</source>
        <translation>die Aufnahme endet innerhalb %1 s nach dem Beginn</translation>
    </message>
    <message>
        <source>the resting force was not measured</source>
        <translation>die Ruhekraft wurde nicht gemessen</translation>
    </message>
    <message>
        <source>the result is not finite</source>
        <translation>das Ergebnis ist nicht endlich</translation>
    </message>
    <message>
        <source>the sampling rate is too low for a spectrum</source>
        <translation>die Abtastrate ist für ein Spektrum zu niedrig</translation>
    </message>
    <message>
        <source>the sampling rate is too low for the band</source>
        <translation>die Abtastrate ist für das Band zu niedrig</translation>
    </message>
    <message>
        <source>the signal does not vary</source>
        <translation>das Signal ändert sich nicht</translation>
    </message>
    <message>
        <source>the spectrum has no peak in the band</source>
        <translation>das Spektrum hat kein Maximum im Band</translation>
    </message>
    <message>
        <source>the spectrum has no range</source>
        <translation>das Spektrum hat keinen Bereich</translation>
    </message>
    <message>
        <source>the speed never changes its slope</source>
        <translation>die Geschwindigkeit ändert nie ihre Steigung</translation>
    </message>
    <message>
        <source>the target has no component at its frequency</source>
        <translation>das Ziel hat keinen Anteil bei seiner Frequenz</translation>
    </message>
    <message>
        <source>the target has no component at this frequency</source>
        <translation>das Ziel hat keinen Anteil bei dieser Frequenz</translation>
    </message>
    <message>
        <source>the target has no width</source>
        <translation>das Ziel hat keine Breite</translation>
    </message>
    <message>
        <source>the target is a share of the baseline maximum of &apos;grip&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil vom Ausgangsmaximum des Griffs, und kein Versuch dieser Sitzung hat sie gemessen</translation>
    </message>
    <message>
        <source>the target is a share of the comfortable force of &apos;grip&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil von der angenehmen Kraft des Griffs, und kein Versuch dieser Sitzung hat sie gemessen</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;grip&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil von der Maximalkraft des Griffs, und kein Versuch dieser Sitzung hat sie gemessen</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;index&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil von der Maximalkraft des Zeigefingers, und kein Versuch dieser Sitzung hat sie gemessen</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;middle&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil von der Maximalkraft des Mittelfingers, und kein Versuch dieser Sitzung hat sie gemessen</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;pinch&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil von der Maximalkraft von Daumen und Zeigefinger, und kein Versuch dieser Sitzung hat sie gemessen</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;thumb&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil von der Maximalkraft des Daumens, und kein Versuch dieser Sitzung hat sie gemessen</translation>
    </message>
    <message>
        <source>the target is zero throughout</source>
        <translation>das Ziel ist durchweg null</translation>
    </message>
    <message>
        <source>the targets lie at different distances</source>
        <translation>die Ziele liegen verschieden weit entfernt</translation>
    </message>
    <message>
        <source>the trial ended before it was reached</source>
        <translation>der Versuch endete, bevor es erreicht war</translation>
    </message>
    <message>
        <source>the trial ended before this target</source>
        <translation>der Versuch endete vor diesem Ziel</translation>
    </message>
    <message>
        <source>the trial holds more values than can be read again</source>
        <translation>der Versuch enthält mehr Werte, als wieder gelesen werden können</translation>
    </message>
    <message>
        <source>the two digits did not touch together</source>
        <translation>die beiden Finger berührten nicht gleichzeitig</translation>
    </message>
    <message>
        <source>there was no contact</source>
        <translation>es gab keinen Kontakt</translation>
    </message>
    <message>
        <source>there was no cue</source>
        <translation>es gab kein Signal</translation>
    </message>
    <message>
        <source>there was no force</source>
        <translation>es gab keine Kraft</translation>
    </message>
    <message>
        <source>there was no grip</source>
        <translation>es gab keinen Griff</translation>
    </message>
    <message>
        <source>there was no hold in which the instructed digit pressed</source>
        <translation>der geforderte Finger drückte in keinem Halt</translation>
    </message>
    <message>
        <source>there was no hold of the instructed digit</source>
        <translation>es gab keinen Halt des geforderten Fingers</translation>
    </message>
    <message>
        <source>there was no level transport</source>
        <translation>es gab keinen geraden Transport</translation>
    </message>
    <message>
        <source>there was no opening force</source>
        <translation>es gab keine Öffnungskraft</translation>
    </message>
    <message>
        <source>there was no repetition</source>
        <translation>es gab keine Wiederholung</translation>
    </message>
    <message>
        <source>this line is longer than %1</source>
        <translation>diese Zeile ist länger als %1</translation>
    </message>
    <message>
        <source>thumb and fingers did not hold the object together</source>
        <translation>Daumen und Finger hielten das Objekt nicht gemeinsam</translation>
    </message>
    <message>
        <source>too few samples for a %1 Hz low-pass</source>
        <translation>zu wenige Messwerte für einen Tiefpass von %1 Hz</translation>
    </message>
    <message>
        <source>too few samples for a sine</source>
        <translation>zu wenige Messwerte für einen Sinus</translation>
    </message>
    <message>
        <source>too few samples for these sines</source>
        <translation>zu wenige Messwerte für diese Sinus</translation>
    </message>
    <message>
        <source>wait another %1 s</source>
        <translation>warten Sie noch %1 s</translation>
    </message>
    <message>
        <source>wait for its end</source>
        <translation>warten Sie das Ende ab</translation>
    </message>
    <message>
        <source>Take everything off the supports and do not touch them.</source>
        <translation>Nehmen Sie alles von den Auflagen und berühren Sie sie nicht.</translation>
    </message>
    <message>
        <source>Guided check passed.</source>
        <translation>Geführte Prüfung bestanden.</translation>
    </message>
    <message>
        <source>Rest and maximum</source>
        <translation>Ruhe und Maximum</translation>
    </message>
    <message>
        <source>Follow a force</source>
        <translation>Einer Kraft folgen</translation>
    </message>
    <message>
        <source>Hold and let go</source>
        <translation>Halten und loslassen</translation>
    </message>
    <message>
        <source>Single fingers, directions</source>
        <translation>Einzelne Finger, Richtungen</translation>
    </message>
    <message>
        <source>Move an object</source>
        <translation>Ein Objekt bewegen</translation>
    </message>
    <message>
        <source>Simulated sensors, arm_push patient</source>
        <translation>Simulierte Sensoren, Patient: mit Armschub</translation>
    </message>
    <message>
        <source>Simulated sensors, direction_error patient</source>
        <translation>Simulierte Sensoren, Patient: mit Richtungsfehler</translation>
    </message>
    <message>
        <source>Simulated sensors, fatiguing patient</source>
        <translation>Simulierte Sensoren, Patient: ermüdend</translation>
    </message>
    <message>
        <source>Simulated sensors, healthy patient</source>
        <translation>Simulierte Sensoren, Patient: gesund</translation>
    </message>
    <message>
        <source>Simulated sensors, inattention patient</source>
        <translation>Simulierte Sensoren, Patient: unaufmerksam</translation>
    </message>
    <message>
        <source>Simulated sensors, mild patient</source>
        <translation>Simulierte Sensoren, Patient: leicht betroffen</translation>
    </message>
    <message>
        <source>Simulated sensors, moderate patient</source>
        <translation>Simulierte Sensoren, Patient: mittel betroffen</translation>
    </message>
    <message>
        <source>Simulated sensors, opening_loss patient</source>
        <translation>Simulierte Sensoren, Patient: ohne Öffnen</translation>
    </message>
    <message>
        <source>Simulated sensors, pain_stop patient</source>
        <translation>Simulierte Sensoren, Patient: Abbruch bei Schmerz</translation>
    </message>
    <message>
        <source>Simulated sensors, paretic patient</source>
        <translation>Simulierte Sensoren, Patient: paretisch</translation>
    </message>
    <message>
        <source>Simulated sensors, sensory_loss patient</source>
        <translation>Simulierte Sensoren, Patient: ohne Gefühl</translation>
    </message>
    <message>
        <source>Simulated sensors, severe patient</source>
        <translation>Simulierte Sensoren, Patient: schwer betroffen</translation>
    </message>
    <message>
        <source>Simulated sensors, slow_wander patient</source>
        <translation>Simulierte Sensoren, Patient: langsames Wandern</translation>
    </message>
    <message>
        <source>Simulated sensors, spastic patient</source>
        <translation>Simulierte Sensoren, Patient: spastisch</translation>
    </message>
    <message>
        <source>Simulated sensors, submaximal patient</source>
        <translation>Simulierte Sensoren, Patient: submaximal</translation>
    </message>
    <message>
        <source>index fx</source>
        <translation>Zeigefinger, Kraft x</translation>
    </message>
    <message>
        <source>index fy</source>
        <translation>Zeigefinger, Kraft y</translation>
    </message>
    <message>
        <source>index fz</source>
        <translation>Zeigefinger, Kraft z</translation>
    </message>
    <message>
        <source>index tx</source>
        <translation>Zeigefinger, Moment x</translation>
    </message>
    <message>
        <source>index ty</source>
        <translation>Zeigefinger, Moment y</translation>
    </message>
    <message>
        <source>index tz</source>
        <translation>Zeigefinger, Moment z</translation>
    </message>
    <message>
        <source>middle fx</source>
        <translation>Mittelfinger, Kraft x</translation>
    </message>
    <message>
        <source>middle fy</source>
        <translation>Mittelfinger, Kraft y</translation>
    </message>
    <message>
        <source>middle fz</source>
        <translation>Mittelfinger, Kraft z</translation>
    </message>
    <message>
        <source>middle tx</source>
        <translation>Mittelfinger, Moment x</translation>
    </message>
    <message>
        <source>middle ty</source>
        <translation>Mittelfinger, Moment y</translation>
    </message>
    <message>
        <source>middle tz</source>
        <translation>Mittelfinger, Moment z</translation>
    </message>
    <message>
        <source>thumb fx</source>
        <translation>Daumen, Kraft x</translation>
    </message>
    <message>
        <source>thumb fy</source>
        <translation>Daumen, Kraft y</translation>
    </message>
    <message>
        <source>thumb fz</source>
        <translation>Daumen, Kraft z</translation>
    </message>
    <message>
        <source>thumb tx</source>
        <translation>Daumen, Moment x</translation>
    </message>
    <message>
        <source>thumb ty</source>
        <translation>Daumen, Moment y</translation>
    </message>
    <message>
        <source>thumb tz</source>
        <translation>Daumen, Moment z</translation>
    </message>
    <message>
        <source>cannot be judged yet</source>
        <translation>noch nicht beurteilbar</translation>
    </message>
    <message>
        <source>improved (confirmed)</source>
        <translation>verbessert (bestätigt)</translation>
    </message>
    <message>
        <source>improved (possible)</source>
        <translation>verbessert (möglich)</translation>
    </message>
    <message>
        <source>not larger than measurement error</source>
        <translation>nicht größer als der Messfehler</translation>
    </message>
    <message>
        <source>wait until it is done, or give another name</source>
        <translation>warten Sie, bis es fertig ist, oder geben Sie einen anderen Namen an</translation>
    </message>
    <message>
        <source>worsened (confirmed)</source>
        <translation>verschlechtert (bestätigt)</translation>
    </message>
    <message>
        <source>worsened (possible)</source>
        <translation>verschlechtert (möglich)</translation>
    </message>
    <message>
        <source>a day of the baseline has no value</source>
        <translation>ein Tag des Ausgangswerts hat keinen Wert</translation>
    </message>
    <message>
        <source>a value is not positive, its error is a share</source>
        <translation>ein Wert ist nicht positiv, sein Fehler ist ein Anteil</translation>
    </message>
    <message>
        <source>more of it is neither better nor worse</source>
        <translation>mehr davon ist weder besser noch schlechter</translation>
    </message>
    <message>
        <source>no assessment after the baseline</source>
        <translation>kein Assessment nach dem Ausgangswert</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>stable pairs of %1 people instead of %2</source>
        <translation>stabile Paare von %1 statt %2 Personen</translation>
    </message>
    <message>
        <source>stable people show no variation</source>
        <translation>stabile Personen zeigen keine Streuung</translation>
    </message>
    <message>
        <source>the affected side is not known</source>
        <translation>die betroffene Seite ist nicht bekannt</translation>
    </message>
    <message>
        <source>the baseline needs two assessment days</source>
        <translation>der Ausgangswert braucht zwei Assessment-Tage</translation>
    </message>
    <message>
        <source>the last assessment has no value</source>
        <translation>das letzte Assessment hat keinen Wert</translation>
    </message>
    <message>
        <source>the level of its trials follows success</source>
        <translation>die Stufe ihrer Versuche folgt dem Erfolg</translation>
    </message>
    <message>
        <source>%1 minutes of work are done: end the session for today.</source>
        <translation>%1 Minuten Arbeit sind getan: Sitzung für heute beenden.</translation>
    </message>
    <message>
        <source>The maximum has fallen by %1 % in this session: stop the work of this hand for today.</source>
        <translation>Das Maximum ist in dieser Sitzung um %1 % gefallen: die Arbeit dieser Hand für heute beenden.</translation>
    </message>
    <message>
        <source>%1 boxes send records, the last is %2</source>
        <translation>%1 Boxen senden Messdaten, die letzte ist %2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1: kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>%1 does not have the calibration that the configuration names%2</source>
        <translation>%1 hat nicht die Kalibrierung, die die Konfiguration nennt%2</translation>
    </message>
    <message>
        <source>%1 has the serial number %2, but the configuration says %3</source>
        <translation>%1 hat die Seriennummer %2, die Konfiguration nennt aber %3</translation>
    </message>
    <message>
        <source>%1 is locked but has an initial velocity</source>
        <translation>%1 ist gesperrt, hat aber eine Anfangsgeschwindigkeit</translation>
    </message>
    <message>
        <source>%1 is no possible length of the filter</source>
        <translation>%1 ist keine mögliche Länge des Filters</translation>
    </message>
    <message>
        <source>%1 is no score of the %2</source>
        <translation>%1 ist kein Wert von %2</translation>
    </message>
    <message>
        <source>%1 is no year of birth</source>
        <translation>%1 ist kein Geburtsjahr</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1 not defined: %2.</source>
        <translation>%1 nicht definiert: %2.</translation>
    </message>
    <message>
        <source>%1 of %2 is a primary measure</source>
        <translation>%1 von %2 ist schon eine Hauptmessgröße</translation>
    </message>
    <message>
        <source>%1 of %2 was changed or is damaged</source>
        <translation>%1 von %2: geändert oder beschädigt</translation>
    </message>
    <message>
        <source>%1 refused a setting (%2)</source>
        <translation>%1 hat eine Einstellung abgelehnt (%2)</translation>
    </message>
    <message>
        <source>%1 sensors do not speak over %2://</source>
        <translation>Sensoren des Typs %1 sprechen nicht über %2://</translation>
    </message>
    <message>
        <source>%1 taps cannot make this cut-off at this rate</source>
        <translation>%1 Koeffizienten schaffen diese Grenzfrequenz bei dieser Rate nicht</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>%1, and the bit rate of the interface: boards leave the factory at 250 kbit/s</source>
        <translation>%1, auch die Bitrate der Schnittstelle: Platinen kommen mit 250 kbit/s aus dem Werk</translation>
    </message>
    <message>
        <source>%1: refused by the database (%2)</source>
        <translation>%1: von der Datenbank abgelehnt (%2)</translation>
    </message>
    <message>
        <source>%1: the database is damaged</source>
        <translation>%1: Die Datenbank ist beschädigt</translation>
    </message>
    <message>
        <source>%1: the database is locked by another program</source>
        <translation>%1: Die Datenbank ist von einem anderen Programm gesperrt</translation>
    </message>
    <message>
        <source>%1: the disk is full or does not answer</source>
        <translation>%1: Der Datenträger ist voll oder antwortet nicht</translation>
    </message>
    <message>
        <source>%1: the file or its folder is not writable</source>
        <translation>%1: Die Datei oder ihr Ordner ist nicht beschreibbar</translation>
    </message>
    <message>
        <source>&apos;%1&apos; appears twice</source>
        <translation>„%1“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no difficulty to adapt</source>
        <translation>„%1“ hat keine Schwierigkeit, die sich anpassen lässt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no digit, so it could be a name or initials</source>
        <translation>„%1“ hat keine Ziffer, könnte also ein Name oder Initialen sein</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds what reads as a date</source>
        <translation>„%1“ enthält etwas, das wie ein Datum aussieht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is before %2</source>
        <translation>„%1“ liegt vor %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no address in numbers</source>
        <translation>„%1“ ist keine Adresse in Zahlen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no day of the calendar</source>
        <translation>„%1“ ist kein Kalendertag</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no kind of treatment</source>
        <translation>„%1“ ist keine Art der Behandlung</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no scale that is known</source>
        <translation>„%1“ ist keine bekannte Skala</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a digit</source>
        <translation>„%1“ ist kein Finger</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a direction</source>
        <translation>„%1“ ist keine Richtung</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>„%1“ ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a force</source>
        <translation>„%1“ ist keine Kraft</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a hand</source>
        <translation>„%1“ ist keine Hand</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that makes sense here</source>
        <translation>„%1“ ist keine hier sinnvolle Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that this parameter takes</source>
        <translation>„%1“ ist keine Zahl, die dieser Parameter annimmt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a positive number</source>
        <translation>„%1“ ist keine positive Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a unit that is known here</source>
        <translation>„%1“ ist keine hier bekannte Einheit</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not in the years %2 to %3</source>
        <translation>„%1“ liegt nicht in den Jahren %2 bis %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known</source>
        <translation>„%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not six numbers</source>
        <translation>„%1“ sind nicht sechs Zahlen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the expected format</source>
        <translation>„%1“ ist nicht das erwartete Format</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a scene</source>
        <translation>„%1“ ist nicht der Name einer Szene</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a task file</source>
        <translation>„%1“ ist nicht der Name einer Aufgabendatei</translation>
    </message>
    <message>
        <source>, group %1, second %2</source>
        <translation>, Gruppe %1, Sekunde %2</translation>
    </message>
    <message>
        <source>, group %1, seconds %2 to %3</source>
        <translation>, Gruppe %1, Sekunden %2 bis %3</translation>
    </message>
    <message>
        <source>0 is out of range</source>
        <translation>0 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>ATI NETCANOEM on %1</source>
        <translation>ATI NETCANOEM an %1</translation>
    </message>
    <message>
        <source>ATI Net F/T on %1</source>
        <translation>ATI Net F/T an %1</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>Adresse wird schon verwendet</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>nicht genug Arbeitsspeicher</translation>
    </message>
    <message>
        <source>Cannot assign requested address</source>
        <translation>die verlangte Adresse kann nicht vergeben werden</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Verbindung verweigert</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>Verbindung von der Gegenstelle getrennt</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Zeitüberschreitung der Verbindung</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät wird schon verwendet</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>Ordner ist nicht leer</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherplatz des Benutzers ist erschöpft</translation>
    </message>
    <message>
        <source>Error while parsing %1: %2</source>
        <translation>Fehler beim Lesen (%1): %2</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei gibt es schon</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname ist zu lang</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>ungültige Angabe</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>JR3 PCI on %1</source>
        <translation>JR3 PCI an %1</translation>
    </message>
    <message>
        <source>JR3 with CAN adaptor on %1</source>
        <translation>JR3 mit CAN-Adapter an %1</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>Netzwerk ist ausgeschaltet</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>Netzwerk ist nicht erreichbar</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>kein Weg zum Gerät</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>kein solches Gerät</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>kein solches Gerät und keine solche Adresse</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Vorgang nicht erlaubt</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Recorded forces, %1</source>
        <translation>Aufgezeichnete Kräfte, %1</translation>
    </message>
    <message>
        <source>Recorded frames of ATI NETCANOEM, %1</source>
        <translation>Aufgezeichnete Telegramme von ATI NETCANOEM, %1</translation>
    </message>
    <message>
        <source>Recorded frames of ATI Net F/T, %1</source>
        <translation>Aufgezeichnete Telegramme von ATI Net F/T, %1</translation>
    </message>
    <message>
        <source>Recorded frames of JR3 PCI, %1</source>
        <translation>Aufgezeichnete Telegramme von JR3 PCI, %1</translation>
    </message>
    <message>
        <source>Recorded frames of JR3 with CAN adaptor, %1</source>
        <translation>Aufgezeichnete Telegramme von JR3 mit CAN-Adapter, %1</translation>
    </message>
    <message>
        <source>Recorded frames of Robotous RFT, %1</source>
        <translation>Aufgezeichnete Telegramme von Robotous RFT, %1</translation>
    </message>
    <message>
        <source>Robotous RFT on %1</source>
        <translation>Robotous RFT an %1</translation>
    </message>
    <message>
        <source>Simulated sensors, %1 patient</source>
        <translation>Simulierte Sensoren, Patient: %1</translation>
    </message>
    <message>
        <source>Text file busy</source>
        <translation>Datei wird gerade ausgeführt</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>zu viele verkettete Verweise</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>a &apos;%&apos; without two hexadecimal digits</source>
        <translation>ein „%“ ohne zwei hexadezimale Ziffern</translation>
    </message>
    <message>
        <source>a calibration belongs to one sensor, and none is named here</source>
        <translation>eine Kalibrierung gehört zu einem Sensor, hier ist keiner genannt</translation>
    </message>
    <message>
        <source>a comment or whitespace</source>
        <translation>ein Kommentar oder Leerraum</translation>
    </message>
    <message>
        <source>a course needs a day</source>
        <translation>ein Verlauf braucht einen Tag</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>ein Datum oder eine Zeit</translation>
    </message>
    <message>
        <source>a frame without &apos;#&apos;</source>
        <translation>ein Telegramm ohne „#“</translation>
    </message>
    <message>
        <source>a hold of %1 s is not possible</source>
        <translation>ein Zeitschritt von %1 s ist nicht möglich</translation>
    </message>
    <message>
        <source>a maximum is measured above the resting force, which no earlier step measures</source>
        <translation>ein Maximum wird über der Ruhekraft gemessen, die kein früherer Schritt misst</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a quaternion of length zero</source>
        <translation>eine Quaternion der Länge null</translation>
    </message>
    <message>
        <source>a rating that is not positive</source>
        <translation>ein Nennwert, der nicht positiv ist</translation>
    </message>
    <message>
        <source>a real bus does not run in virtual time</source>
        <translation>ein echter Bus läuft nicht in virtueller Zeit</translation>
    </message>
    <message>
        <source>a real device cannot run in virtual time</source>
        <translation>ein echtes Gerät kann nicht in virtueller Zeit laufen</translation>
    </message>
    <message>
        <source>a second follows one that was not full</source>
        <translation>eine Sekunde folgt auf eine, die nicht voll war</translation>
    </message>
    <message>
        <source>a session in real time is not recorded into a scratch file</source>
        <translation>eine Sitzung in Echtzeit wird nicht in eine Wegwerfdatei aufgezeichnet</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>eine Tabelle</translation>
    </message>
    <message>
        <source>a time without &apos;)&apos;</source>
        <translation>eine Zeit ohne „)“</translation>
    </message>
    <message>
        <source>a travel limit of %1 has no meaning while all three rotations are free</source>
        <translation>eine Weggrenze von %1 hat keinen Sinn, solange alle drei Drehungen frei sind</translation>
    </message>
    <message>
        <source>a travel limit of %1 while springs or dampers at an angle couple the axes</source>
        <translation>eine Weggrenze von %1, während schräge Federn oder Dämpfer die Achsen koppeln</translation>
    </message>
    <message>
        <source>a trial cannot end as running</source>
        <translation>ein Versuch kann nicht als laufend enden</translation>
    </message>
    <message>
        <source>a trial is being recorded</source>
        <translation>ein Versuch wird gerade aufgezeichnet</translation>
    </message>
    <message>
        <source>add %1 or %2</source>
        <translation>%1 oder %2 ergänzen</translation>
    </message>
    <message>
        <source>add ?protocol=rft or ?config=FILE</source>
        <translation>?protocol=rft oder ?config=DATEI ergänzen</translation>
    </message>
    <message>
        <source>add a [[finger]] table for each sensor</source>
        <translation>für jeden Sensor eine Tabelle [[finger]] ergänzen</translation>
    </message>
    <message>
        <source>add a [[sensor]] with finger = &quot;%1&quot;</source>
        <translation>[[sensor]] mit finger = &quot;%1&quot; ergänzen</translation>
    </message>
    <message>
        <source>add a [difficulty] table to the task, or leave out adaptive</source>
        <translation>der Aufgabe eine Tabelle [difficulty] geben oder adaptive weglassen</translation>
    </message>
    <message>
        <source>add at least one [[axis]]</source>
        <translation>mindestens eine [[axis]] ergänzen</translation>
    </message>
    <message>
        <source>add at least one [[item]]</source>
        <translation>mindestens ein [[item]] ergänzen</translation>
    </message>
    <message>
        <source>add at least one [[step]]</source>
        <translation>mindestens einen [[step]] ergänzen</translation>
    </message>
    <message>
        <source>add at least one [[target]]</source>
        <translation>mindestens ein [[target]] ergänzen</translation>
    </message>
    <message>
        <source>add columns such as thumb_fx_N, thumb_fy_N, thumb_fz_N</source>
        <translation>Spalten wie thumb_fx_N, thumb_fy_N, thumb_fz_N ergänzen</translation>
    </message>
    <message>
        <source>add e.g. thumb_direction = [0, 0, 1]</source>
        <translation>z. B. thumb_direction = [0, 0, 1] ergänzen</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>ergänzen</translation>
    </message>
    <message>
        <source>add the column</source>
        <translation>die Spalte ergänzen</translation>
    </message>
    <message>
        <source>add the time of each row in seconds</source>
        <translation>die Zeit jeder Zeile in Sekunden ergänzen</translation>
    </message>
    <message>
        <source>adding a patient</source>
        <translation>Patienten anlegen</translation>
    </message>
    <message>
        <source>adding an account</source>
        <translation>Konto anlegen</translation>
    </message>
    <message>
        <source>administrator</source>
        <translation>Administrator</translation>
    </message>
    <message>
        <source>align them, or write wrench_frame = &quot;hand&quot;</source>
        <translation>sie ausrichten oder wrench_frame = &quot;hand&quot; schreiben</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an identifier that has neither 3 nor 8 hexadecimal digits</source>
        <translation>eine Kennung, die weder 3 noch 8 hexadezimale Ziffern hat</translation>
    </message>
    <message>
        <source>an identifier that is too large</source>
        <translation>eine zu große Kennung</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>another file has this name now</source>
        <translation>eine andere Datei hat jetzt diesen Namen</translation>
    </message>
    <message>
        <source>another program has changed the file meanwhile</source>
        <translation>ein anderes Programm hat die Datei inzwischen geändert</translation>
    </message>
    <message>
        <source>another program has changed this file meanwhile</source>
        <translation>ein anderes Programm hat diese Datei inzwischen geändert</translation>
    </message>
    <message>
        <source>another program has it open</source>
        <translation>ein anderes Programm hat sie geöffnet</translation>
    </message>
    <message>
        <source>another program records into it now</source>
        <translation>ein anderes Programm zeichnet jetzt darin auf</translation>
    </message>
    <message>
        <source>another program records into the file now</source>
        <translation>ein anderes Programm zeichnet jetzt in die Datei auf</translation>
    </message>
    <message>
        <source>append one second at a time</source>
        <translation>jeweils eine Sekunde anfügen</translation>
    </message>
    <message>
        <source>append the seconds in order</source>
        <translation>die Sekunden der Reihe nach anfügen</translation>
    </message>
    <message>
        <source>are fewer than two</source>
        <translation>sind weniger als zwei</translation>
    </message>
    <message>
        <source>are too many</source>
        <translation>sind zu viele</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>ask an administrator to put you into the group dialout</source>
        <translation>einen Administrator bitten, Sie in die Gruppe dialout aufzunehmen</translation>
    </message>
    <message>
        <source>asks for more than the whole force</source>
        <translation>verlangt mehr als die ganze Kraft</translation>
    </message>
    <message>
        <source>asks for no login</source>
        <translation>verlangt keine Anmeldung</translation>
    </message>
    <message>
        <source>asks no digit</source>
        <translation>verlangt keinen Finger</translation>
    </message>
    <message>
        <source>attempts can only agree with each other</source>
        <translation>nur Versuche können miteinander übereinstimmen</translation>
    </message>
    <message>
        <source>bare key starting character or string delimiter</source>
        <translation>Beginn eines Schlüssels oder Anführungszeichen</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>Basis %1</translation>
    </message>
    <message>
        <source>begin a new session</source>
        <translation>eine neue Sitzung beginnen</translation>
    </message>
    <message>
        <source>begin it first</source>
        <translation>zuerst damit beginnen</translation>
    </message>
    <message>
        <source>begin one</source>
        <translation>eine beginnen</translation>
    </message>
    <message>
        <source>beginning a session</source>
        <translation>Sitzung beginnen</translation>
    </message>
    <message>
        <source>beginning a trial</source>
        <translation>Versuch beginnen</translation>
    </message>
    <message>
        <source>blocks for %1 instead of %2 groups</source>
        <translation>Blöcke für %1 statt %2 Gruppen</translation>
    </message>
    <message>
        <source>boolean</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>calibration slot %1 holds a matrix, counts or units that cannot be used</source>
        <translation>Kalibrierplatz %1 enthält eine Matrix, Zählwerte oder Einheiten, die nicht verwendbar sind</translation>
    </message>
    <message>
        <source>calibration slot %1 was asked for, it chose slot %2</source>
        <translation>Kalibrierplatz %1 war verlangt, er hat Platz %2 gewählt</translation>
    </message>
    <message>
        <source>cannot be a file here</source>
        <translation>kann hier keine Datei sein</translation>
    </message>
    <message>
        <source>cannot be locked: %1</source>
        <translation>kann nicht gesperrt werden: %1</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>kann nicht gemacht werden: %1</translation>
    </message>
    <message>
        <source>cannot be opened for %1</source>
        <translation>kann nicht geöffnet werden (%1)</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>cannot be reached</source>
        <translation>kann nicht erreicht werden</translation>
    </message>
    <message>
        <source>cannot be reached: %1</source>
        <translation>kann nicht erreicht werden: %1</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>cannot be renamed: %1</source>
        <translation>kann nicht umbenannt werden: %1</translation>
    </message>
    <message>
        <source>the PIN cannot be used now</source>
        <translation>die PIN kann jetzt nicht verwendet werden</translation>
    </message>
    <message>
        <source>cannot be written, so the reading of an identity could not be logged</source>
        <translation>kann nicht geschrieben werden, das Lesen einer Identität ließe sich also nicht protokollieren</translation>
    </message>
    <message>
        <source>cannot redefine existing %1 &apos;%2&apos;</source>
        <translation>schon vorhanden (%1) und nicht noch einmal definierbar: „%2“</translation>
    </message>
    <message>
        <source>cannot redefine existing %1 &apos;%2&apos; as %3</source>
        <translation>schon vorhanden (%1) und nicht neu definierbar: „%2“ als %3</translation>
    </message>
    <message>
        <source>changes nothing</source>
        <translation>ändert nichts</translation>
    </message>
    <message>
        <source>changing the user</source>
        <translation>Person wechseln</translation>
    </message>
    <message>
        <source>check --patient and --session (1 is the patient&apos;s first)</source>
        <translation>--patient und --session prüfen (1 ist die erste Sitzung des Patienten)</translation>
    </message>
    <message>
        <source>check its cable; after it was plugged in the card needs ten seconds</source>
        <translation>das Kabel prüfen; nach dem Einstecken braucht die Karte zehn Sekunden</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>die Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>check its power, its cable and its address</source>
        <translation>Stromversorgung, Kabel und Adresse prüfen</translation>
    </message>
    <message>
        <source>check its power, its cable and the 120 ohm at both ends of the bus</source>
        <translation>Stromversorgung, Kabel und die 120 Ohm an beiden Enden des Busses prüfen</translation>
    </message>
    <message>
        <source>check its power, its cable, its address and the baud rate</source>
        <translation>Stromversorgung, Kabel, Adresse und Baudrate prüfen</translation>
    </message>
    <message>
        <source>check protocol and addresses of the device file</source>
        <translation>Protokoll und Adressen der Gerätedatei prüfen</translation>
    </message>
    <message>
        <source>check rate and filter_Hz against the sensor&apos;s model</source>
        <translation>rate und filter_Hz mit dem Modell des Sensors vergleichen</translation>
    </message>
    <message>
        <source>check that it is a log</source>
        <translation>prüfen, ob es ein Mitschnitt ist</translation>
    </message>
    <message>
        <source>check that it is a log of this protocol</source>
        <translation>prüfen, ob es ein Mitschnitt dieses Protokolls ist</translation>
    </message>
    <message>
        <source>check that it is a table of numbers with line ends</source>
        <translation>prüfen, ob es eine Zahlentabelle mit Zeilenenden ist</translation>
    </message>
    <message>
        <source>check that it is the right file</source>
        <translation>prüfen, ob es die richtige Datei ist</translation>
    </message>
    <message>
        <source>check that the driver jr3_pci is loaded and that you may read the file</source>
        <translation>prüfen, ob der Treiber jr3_pci geladen ist und Sie die Datei lesen dürfen</translation>
    </message>
    <message>
        <source>check that the kernel modules can and can_raw are loaded</source>
        <translation>prüfen, ob die Kernelmodule can und can_raw geladen sind</translation>
    </message>
    <message>
        <source>check the adapter and its cable</source>
        <translation>Adapter und Kabel prüfen</translation>
    </message>
    <message>
        <source>check the code</source>
        <translation>den Code prüfen</translation>
    </message>
    <message>
        <source>check the code, or record a session with it first</source>
        <translation>den Code prüfen oder erst eine Sitzung mit ihm aufzeichnen</translation>
    </message>
    <message>
        <source>check the device&apos;s power, its network cable and its address</source>
        <translation>Stromversorgung, Netzwerkkabel und Adresse des Geräts prüfen</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>den Datenträger prüfen</translation>
    </message>
    <message>
        <source>check the disk and the folder</source>
        <translation>Datenträger und Ordner prüfen</translation>
    </message>
    <message>
        <source>check the disk and the permissions</source>
        <translation>Datenträger und Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>check the disk and the permissions of its folder</source>
        <translation>Datenträger und Zugriffsrechte des Ordners prüfen</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>den Pfad prüfen</translation>
    </message>
    <message>
        <source>check the path and its permissions</source>
        <translation>Pfad und Zugriffsrechte prüfen</translation>
    </message>
    <message>
        <source>check the permissions of both, or copy the file to a writable folder</source>
        <translation>die Zugriffsrechte beider prüfen oder die Datei in einen beschreibbaren Ordner kopieren</translation>
    </message>
    <message>
        <source>check the permissions of the file and its folder</source>
        <translation>die Zugriffsrechte der Datei und ihres Ordners prüfen</translation>
    </message>
    <message>
        <source>check the permissions of the folder</source>
        <translation>die Zugriffsrechte des Ordners prüfen</translation>
    </message>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>einen Ordner wählen, in den Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>choose a level of at least %1, or a wider band</source>
        <translation>ein Niveau von mindestens %1 oder ein breiteres Band wählen</translation>
    </message>
    <message>
        <source>choose a longer one; several words are easy to keep in mind</source>
        <translation>ein längeres wählen; mehrere Wörter merkt man sich leicht</translation>
    </message>
    <message>
        <source>choose a lower level</source>
        <translation>ein niedrigeres Niveau wählen</translation>
    </message>
    <message>
        <source>choose a scene in which it can turn about one alone</source>
        <translation>eine Szene wählen, in der es sich um eine allein drehen kann</translation>
    </message>
    <message>
        <source>choose an empty folder for --out</source>
        <translation>für --out einen leeren Ordner wählen</translation>
    </message>
    <message>
        <source>choose another code</source>
        <translation>einen anderen Code wählen</translation>
    </message>
    <message>
        <source>choose another factor</source>
        <translation>einen anderen Faktor wählen</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>choose another name or folder</source>
        <translation>einen anderen Namen oder Ordner wählen</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>etwas anderes wählen</translation>
    </message>
    <message>
        <source>choose another one: the audit log names people</source>
        <translation>einen anderen wählen: Das Zugriffsprotokoll nennt Personen</translation>
    </message>
    <message>
        <source>choose another task, or read the recording with isograsp import</source>
        <translation>eine andere Aufgabe wählen oder die Aufzeichnung mit isograsp import lesen</translation>
    </message>
    <message>
        <source>choose one that is there</source>
        <translation>etwas Vorhandenes wählen</translation>
    </message>
    <message>
        <source>clinical score</source>
        <translation>klinischer Wert</translation>
    </message>
    <message>
        <source>close it and start again</source>
        <translation>schließen und neu beginnen</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>andere Programme schließen</translation>
    </message>
    <message>
        <source>close other programs and try again</source>
        <translation>andere Programme schließen und erneut versuchen</translation>
    </message>
    <message>
        <source>close that program or wait until it is done</source>
        <translation>jenes Programm schließen oder warten, bis es fertig ist</translation>
    </message>
    <message>
        <source>close that program, then restore</source>
        <translation>jenes Programm schließen, dann wiederherstellen</translation>
    </message>
    <message>
        <source>closing a trial</source>
        <translation>Versuch abschließen</translation>
    </message>
    <message>
        <source>comfortable force</source>
        <translation>angenehme Kraft</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>comma or closing &apos;]&apos;</source>
        <translation>Komma oder „]“</translation>
    </message>
    <message>
        <source>comma or closing &apos;}&apos;</source>
        <translation>Komma oder „}“</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>connect the right sensor or correct serial_number</source>
        <translation>den richtigen Sensor anschließen oder serial_number berichtigen</translation>
    </message>
    <message>
        <source>copy all 56 digits from the printed page</source>
        <translation>alle 56 Ziffern von der gedruckten Seite abschreiben</translation>
    </message>
    <message>
        <source>copy the file to where you may write</source>
        <translation>die Datei dorthin kopieren, wo Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>correct or remove the calibration file</source>
        <translation>die Kalibrierdatei berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>correct subdevice in the configuration: the first sensor is 0</source>
        <translation>subdevice in der Konfiguration berichtigen: Der erste Sensor ist 0</translation>
    </message>
    <message>
        <source>correct the mapping; the file has: %1</source>
        <translation>die Zuordnung berichtigen; die Datei hat: %1</translation>
    </message>
    <message>
        <source>correct the number, or the scale of the mapping</source>
        <translation>die Zahl oder die Skala der Zuordnung berichtigen</translation>
    </message>
    <message>
        <source>correct the syntax</source>
        <translation>die Syntax berichtigen</translation>
    </message>
    <message>
        <source>could not be made</source>
        <translation>konnte nicht gemacht werden</translation>
    </message>
    <message>
        <source>could not be made: %1</source>
        <translation>konnte nicht gemacht werden: %1</translation>
    </message>
    <message>
        <source>could not be written completely</source>
        <translation>konnte nicht vollständig geschrieben werden</translation>
    </message>
    <message>
        <source>could not determine value type</source>
        <translation>die Art des Werts ist nicht zu erkennen</translation>
    </message>
    <message>
        <source>damaged (checksum)</source>
        <translation>beschädigt (Prüfsumme)</translation>
    </message>
    <message>
        <source>damaged (content hash)</source>
        <translation>beschädigt (Inhalts-Hash)</translation>
    </message>
    <message>
        <source>damaged (content)</source>
        <translation>beschädigt (Inhalt)</translation>
    </message>
    <message>
        <source>data of a CAN FD frame that cannot be read</source>
        <translation>Daten eines CAN-FD-Telegramms, die nicht gelesen werden können</translation>
    </message>
    <message>
        <source>data that are not up to 8 bytes of two hexadecimal digits</source>
        <translation>Daten, die nicht aus bis zu 8 Bytes mit zwei hexadezimalen Ziffern bestehen</translation>
    </message>
    <message>
        <source>date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>date-time</source>
        <translation>Datum und Zeit</translation>
    </message>
    <message>
        <source>date-time offset</source>
        <translation>Zeitverschiebung</translation>
    </message>
    <message>
        <source>decimal digit</source>
        <translation>eine Dezimalziffer</translation>
    </message>
    <message>
        <source>differs from the time in %1</source>
        <translation>weicht von der Zeit in %1 ab</translation>
    </message>
    <message>
        <source>digit</source>
        <translation>eine Ziffer</translation>
    </message>
    <message>
        <source>do not measure with it: have the sensor checked or correct the configuration</source>
        <translation>nicht damit messen: den Sensor prüfen lassen oder die Konfiguration berichtigen</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>gibt es nicht</translation>
    </message>
    <message>
        <source>does not increase</source>
        <translation>nimmt nicht zu</translation>
    </message>
    <message>
        <source>does not tell its rate</source>
        <translation>nennt seine Rate nicht</translation>
    </message>
    <message>
        <source>duplicate it first</source>
        <translation>zuerst duplizieren</translation>
    </message>
    <message>
        <source>duplicate your text, then Revert shows what stands there</source>
        <translation>Ihren Text duplizieren; „Zurücksetzen“ zeigt dann, was dort steht</translation>
    </message>
    <message>
        <source>encountered end-of-file</source>
        <translation>das Ende der Datei kam zu früh</translation>
    </message>
    <message>
        <source>end it before the next one begins</source>
        <translation>ihn beenden, bevor der nächste beginnt</translation>
    </message>
    <message>
        <source>end that session, then erase</source>
        <translation>jene Sitzung beenden, dann löschen</translation>
    </message>
    <message>
        <source>end that session, then migrate</source>
        <translation>jene Sitzung beenden, dann umstellen</translation>
    </message>
    <message>
        <source>end that session, then restore</source>
        <translation>jene Sitzung beenden, dann wiederherstellen</translation>
    </message>
    <message>
        <source>end the trial after the last second</source>
        <translation>den Versuch nach der letzten Sekunde beenden</translation>
    </message>
    <message>
        <source>ending a session</source>
        <translation>Sitzung beenden</translation>
    </message>
    <message>
        <source>ends after %1 rows, before %2</source>
        <translation>endet nach %1 Zeilen, vor %2</translation>
    </message>
    <message>
        <source>erasing a person</source>
        <translation>Person löschen</translation>
    </message>
    <message>
        <source>exceeded maximum nested value depth of %1</source>
        <translation>tiefer geschachtelt als %1</translation>
    </message>
    <message>
        <source>exchange the two</source>
        <translation>die beiden tauschen</translation>
    </message>
    <message>
        <source>exists already</source>
        <translation>gibt es schon</translation>
    </message>
    <message>
        <source>expected %1, saw %2</source>
        <translation>erwartet: %1, gefunden: %2</translation>
    </message>
    <message>
        <source>exponent digit</source>
        <translation>eine Ziffer des Exponenten</translation>
    </message>
    <message>
        <source>exponent digit or sign</source>
        <translation>eine Ziffer oder das Vorzeichen des Exponenten</translation>
    </message>
    <message>
        <source>fewer than two rows</source>
        <translation>weniger als zwei Zeilen</translation>
    </message>
    <message>
        <source>floating-point</source>
        <translation>Kommazahl</translation>
    </message>
    <message>
        <source>fractional digits</source>
        <translation>Nachkommastellen</translation>
    </message>
    <message>
        <source>free one rotation or all three</source>
        <translation>eine oder alle drei Drehungen freigeben</translation>
    </message>
    <message>
        <source>free some disk space and check the permissions of the folder</source>
        <translation>Speicherplatz freigeben und die Zugriffsrechte des Ordners prüfen</translation>
    </message>
    <message>
        <source>free some space; everything confirmed before is stored</source>
        <translation>Speicherplatz freigeben; alles zuvor Bestätigte ist gespeichert</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>%1 angeben</translation>
    </message>
    <message>
        <source>give --passphrase-file, or --user and --password-file</source>
        <translation>--passphrase-file oder --user und --password-file angeben</translation>
    </message>
    <message>
        <source>give 0 (never wait) or 0.01 to 1000</source>
        <translation>0 (nie warten) oder 0.01 bis 1000 angeben</translation>
    </message>
    <message>
        <source>give 1 or -1</source>
        <translation>1 oder -1 angeben</translation>
    </message>
    <message>
        <source>give 1 to 64 characters on one line, no blank at either end</source>
        <translation>1 bis 64 Zeichen in einer Zeile angeben, ohne Leerzeichen am Rand</translation>
    </message>
    <message>
        <source>give a CSV file whose first line names the columns</source>
        <translation>eine CSV-Datei angeben, deren erste Zeile die Spalten nennt</translation>
    </message>
    <message>
        <source>give a database that is kept</source>
        <translation>eine Datenbank angeben, die aufbewahrt wird</translation>
    </message>
    <message>
        <source>give a file made by isograsp db init</source>
        <translation>eine Datei angeben, die isograsp db init gemacht hat</translation>
    </message>
    <message>
        <source>give a file whose first line is: format = &quot;%1&quot;</source>
        <translation>eine Datei angeben, deren erste Zeile format = &quot;%1&quot; lautet</translation>
    </message>
    <message>
        <source>give a log with lines like %1</source>
        <translation>einen Mitschnitt mit Zeilen wie %1 angeben</translation>
    </message>
    <message>
        <source>give a lower fir_cutoff_Hz</source>
        <translation>eine kleinere fir_cutoff_Hz angeben</translation>
    </message>
    <message>
        <source>give a number above 0</source>
        <translation>eine Zahl über 0 angeben</translation>
    </message>
    <message>
        <source>give a rate of 50 to 1000 Hz</source>
        <translation>eine Rate von 50 bis 1000 Hz angeben</translation>
    </message>
    <message>
        <source>give a year from %1 on</source>
        <translation>ein Jahr ab %1 angeben</translation>
    </message>
    <message>
        <source>give address for each [[sensor]]</source>
        <translation>address für jeden [[sensor]] angeben</translation>
    </message>
    <message>
        <source>give all groups of the trial at once</source>
        <translation>alle Gruppen des Versuchs zugleich angeben</translation>
    </message>
    <message>
        <source>give an odd number from 3 to %1</source>
        <translation>eine ungerade Zahl von 3 bis %1 angeben</translation>
    </message>
    <message>
        <source>give an odd number of taps</source>
        <translation>eine ungerade Zahl von Koeffizienten angeben</translation>
    </message>
    <message>
        <source>give another name</source>
        <translation>einen anderen Namen angeben</translation>
    </message>
    <message>
        <source>give at least one group</source>
        <translation>mindestens eine Gruppe angeben</translation>
    </message>
    <message>
        <source>give at least two moments, or none</source>
        <translation>mindestens zwei Momente oder keines angeben</translation>
    </message>
    <message>
        <source>give at least two rows</source>
        <translation>mindestens zwei Zeilen angeben</translation>
    </message>
    <message>
        <source>give at most 1024 characters</source>
        <translation>höchstens 1024 Zeichen angeben</translation>
    </message>
    <message>
        <source>give each finger once</source>
        <translation>jeden Finger einmal angeben</translation>
    </message>
    <message>
        <source>give either the rate or the column that holds the time</source>
        <translation>entweder die Rate oder die Spalte mit der Zeit angeben</translation>
    </message>
    <message>
        <source>give every group one row per sample</source>
        <translation>jeder Gruppe eine Zeile je Messwert geben</translation>
    </message>
    <message>
        <source>give every line %1 fields</source>
        <translation>jeder Zeile %1 Felder geben</translation>
    </message>
    <message>
        <source>give every row a time</source>
        <translation>jeder Zeile eine Zeit geben</translation>
    </message>
    <message>
        <source>give every sensor its own</source>
        <translation>jedem Sensor seinen eigenen geben</translation>
    </message>
    <message>
        <source>give it damping, or the object mass</source>
        <translation>Dämpfung oder dem Objekt Masse geben</translation>
    </message>
    <message>
        <source>give it once</source>
        <translation>einmal angeben</translation>
    </message>
    <message>
        <source>give logs of the same length</source>
        <translation>Mitschnitte gleicher Länge angeben</translation>
    </message>
    <message>
        <source>give more taps, a higher fir_cutoff_Hz or a lower rate_Hz</source>
        <translation>mehr Koeffizienten, eine größere fir_cutoff_Hz oder eine kleinere rate_Hz angeben</translation>
    </message>
    <message>
        <source>give one from %1 to %2</source>
        <translation>eine von %1 bis %2 angeben</translation>
    </message>
    <message>
        <source>give one of: %1</source>
        <translation>eines davon angeben: %1</translation>
    </message>
    <message>
        <source>give the last day of that time</source>
        <translation>den letzten Tag dieser Zeit angeben</translation>
    </message>
    <message>
        <source>give the person&apos;s name</source>
        <translation>den Namen der Person angeben</translation>
    </message>
    <message>
        <source>give the sensor&apos;s serial_number too</source>
        <translation>auch die serial_number des Sensors angeben</translation>
    </message>
    <message>
        <source>give the value, or leave all fields of the finger empty</source>
        <translation>den Wert angeben oder alle Felder des Fingers leer lassen</translation>
    </message>
    <message>
        <source>give three numbers above 0</source>
        <translation>drei Zahlen über 0 angeben</translation>
    </message>
    <message>
        <source>give times that increase</source>
        <translation>zunehmende Zeiten angeben</translation>
    </message>
    <message>
        <source>give true wrench = matrix * sensor&apos;s wrench, both in N and N m</source>
        <translation>wahre Kräfte = Matrix * Kräfte des Sensors angeben, beide in N und N m</translation>
    </message>
    <message>
        <source>give two directions that are not parallel</source>
        <translation>zwei Richtungen angeben, die nicht parallel sind</translation>
    </message>
    <message>
        <source>give values as docs/file_formats.md describes them</source>
        <translation>Werte angeben, wie docs/file_formats.md sie beschreibt</translation>
    </message>
    <message>
        <source>give w, x, y, z of a rotation</source>
        <translation>w, x, y, z einer Drehung angeben</translation>
    </message>
    <message>
        <source>give year, month and day, such as 1950-03-05</source>
        <translation>Jahr, Monat und Tag angeben, etwa 1950-03-05</translation>
    </message>
    <message>
        <source>give year, month and day, such as 2026-03-05</source>
        <translation>Jahr, Monat und Tag angeben, etwa 2026-03-05</translation>
    </message>
    <message>
        <source>gives too many lines for this duration</source>
        <translation>ergibt zu viele Linien für diese Dauer</translation>
    </message>
    <message>
        <source>has %1 characters instead of 2 to 32</source>
        <translation>hat %1 Zeichen statt 2 bis 32</translation>
    </message>
    <message>
        <source>has a format that this program does not know</source>
        <translation>hat ein Format, das dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>has a key of more than %1 parts</source>
        <translation>hat einen Schlüssel aus mehr als %1 Teilen</translation>
    </message>
    <message>
        <source>has another length than t_s</source>
        <translation>hat eine andere Länge als t_s</translation>
    </message>
    <message>
        <source>has fewer than %1 characters</source>
        <translation>hat weniger als %1 Zeichen</translation>
    </message>
    <message>
        <source>has no direction</source>
        <translation>hat keine Richtung</translation>
    </message>
    <message>
        <source>has no length</source>
        <translation>hat keine Länge</translation>
    </message>
    <message>
        <source>has the level that the step begins at</source>
        <translation>hat das Niveau, bei dem der Sprung beginnt</translation>
    </message>
    <message>
        <source>has the serial number &apos;%1&apos;, but the configuration says &apos;%2&apos;</source>
        <translation>hat die Seriennummer „%1“, die Konfiguration nennt aber „%2“</translation>
    </message>
    <message>
        <source>has two contacts</source>
        <translation>hat zwei Kontakte</translation>
    </message>
    <message>
        <source>has two limits</source>
        <translation>hat zwei Grenzen</translation>
    </message>
    <message>
        <source>hex digit</source>
        <translation>eine hexadezimale Ziffer</translation>
    </message>
    <message>
        <source>holds %1 that is not a finite number</source>
        <translation>enthält %1, also keine endliche Zahl</translation>
    </message>
    <message>
        <source>holds %1, not a table</source>
        <translation>enthält %1 statt einer Tabelle</translation>
    </message>
    <message>
        <source>holds %1, not text</source>
        <translation>enthält %1 statt Text</translation>
    </message>
    <message>
        <source>holds a character other than letters, digits and &apos;-&apos;</source>
        <translation>enthält ein anderes Zeichen als Buchstaben, Ziffern und „-“</translation>
    </message>
    <message>
        <source>holds a control character</source>
        <translation>enthält ein Steuerzeichen</translation>
    </message>
    <message>
        <source>holds a zero byte</source>
        <translation>enthält ein Nullbyte</translation>
    </message>
    <message>
        <source>holds no finger&apos;s forces</source>
        <translation>enthält von keinem Finger Kräfte</translation>
    </message>
    <message>
        <source>holds no frame</source>
        <translation>enthält kein Telegramm</translation>
    </message>
    <message>
        <source>holds no header line</source>
        <translation>enthält keine Kopfzeile</translation>
    </message>
    <message>
        <source>holds no sample of these sensors</source>
        <translation>enthält keinen Messwert dieser Sensoren</translation>
    </message>
    <message>
        <source>holds no such trial</source>
        <translation>enthält keinen solchen Versuch</translation>
    </message>
    <message>
        <source>identifier %1</source>
        <translation>Kennung %1</translation>
    </message>
    <message>
        <source>identities are not stored in a database without protection</source>
        <translation>in einer Datenbank ohne Schutz werden keine Identitäten gespeichert</translation>
    </message>
    <message>
        <source>in an emergency give the reason; it is logged</source>
        <translation>im Notfall den Grund angeben; er wird protokolliert</translation>
    </message>
    <message>
        <source>index</source>
        <translation>Zeigefinger</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>inline table</source>
        <translation>Tabelle in einer Zeile</translation>
    </message>
    <message>
        <source>install libcomedi-dev and build it again</source>
        <translation>libcomedi-dev installieren und das Programm neu bauen</translation>
    </message>
    <message>
        <source>install the newer program; report and export still read it if they can</source>
        <translation>das neuere Programm installieren; Bericht und Export lesen sie noch, wenn sie können</translation>
    </message>
    <message>
        <source>is %1, not a finite number</source>
        <translation>ist %1, keine endliche Zahl</translation>
    </message>
    <message>
        <source>is %1, not a list of tables</source>
        <translation>ist %1, keine Liste von Tabellen</translation>
    </message>
    <message>
        <source>is %1, not a table</source>
        <translation>ist %1, keine Tabelle</translation>
    </message>
    <message>
        <source>is %1, not an array of %2 numbers</source>
        <translation>ist %1, keine Liste aus %2 Zahlen</translation>
    </message>
    <message>
        <source>is %1, not an array of texts</source>
        <translation>ist %1, keine Liste von Texten</translation>
    </message>
    <message>
        <source>is %1, not an integer</source>
        <translation>ist %1, keine ganze Zahl</translation>
    </message>
    <message>
        <source>is %1, not text</source>
        <translation>ist %1, kein Text</translation>
    </message>
    <message>
        <source>is %1, not true or false</source>
        <translation>ist %1, nicht true oder false</translation>
    </message>
    <message>
        <source>is 0 on the free axis %1 that has no %2</source>
        <translation>ist 0 auf der freien Achse %1, die nichts davon hat: %2</translation>
    </message>
    <message>
        <source>is a database of another program</source>
        <translation>ist die Datenbank eines anderen Programms</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is a task of recordings, which nobody can do live</source>
        <translation>ist eine Aufgabe aus Aufzeichnungen, die niemand live ausführen kann</translation>
    </message>
    <message>
        <source>is above %1</source>
        <translation>liegt über %1</translation>
    </message>
    <message>
        <source>is below 2</source>
        <translation>liegt unter 2</translation>
    </message>
    <message>
        <source>is below least_wait_s</source>
        <translation>liegt unter least_wait_s</translation>
    </message>
    <message>
        <source>is below one cycle in this duration</source>
        <translation>liegt bei dieser Dauer unter einem Zyklus</translation>
    </message>
    <message>
        <source>is below repetitions</source>
        <translation>liegt unter repetitions</translation>
    </message>
    <message>
        <source>is driven twice</source>
        <translation>wird zweimal bewegt</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is larger than 4 MiB</source>
        <translation>ist größer als 4 MiB</translation>
    </message>
    <message>
        <source>is larger than 64 MiB</source>
        <translation>ist größer als 64 MiB</translation>
    </message>
    <message>
        <source>is locked</source>
        <translation>ist gesperrt</translation>
    </message>
    <message>
        <source>is longer than 4096 bytes</source>
        <translation>ist länger als 4096 Bytes</translation>
    </message>
    <message>
        <source>is longer than push_s</source>
        <translation>ist länger als push_s</translation>
    </message>
    <message>
        <source>is longer than reproduce_s</source>
        <translation>ist länger als reproduce_s</translation>
    </message>
    <message>
        <source>is longer than squeeze_s</source>
        <translation>ist länger als squeeze_s</translation>
    </message>
    <message>
        <source>is mapped twice</source>
        <translation>ist zweimal zugeordnet</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is negative</source>
        <translation>ist negativ</translation>
    </message>
    <message>
        <source>is no day of the calendar in the years 1900 to 2099</source>
        <translation>ist kein Kalendertag in den Jahren 1900 bis 2099</translation>
    </message>
    <message>
        <source>is no name of an account</source>
        <translation>ist kein Name für ein Konto</translation>
    </message>
    <message>
        <source>is no recovery key: a digit is missing or mistyped</source>
        <translation>ist kein Wiederherstellungsschlüssel: Eine Ziffer fehlt oder ist falsch</translation>
    </message>
    <message>
        <source>is no window of rows</source>
        <translation>ist kein Fenster aus Zeilen</translation>
    </message>
    <message>
        <source>is not 4 to 12 digits</source>
        <translation>hat nicht 4 bis 12 Ziffern</translation>
    </message>
    <message>
        <source>is not a closing force</source>
        <translation>ist keine Schließkraft</translation>
    </message>
    <message>
        <source>is not a database</source>
        <translation>ist keine Datenbank</translation>
    </message>
    <message>
        <source>is not a plain file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is not a whole number</source>
        <translation>ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>is not above the least level</source>
        <translation>liegt nicht über dem kleinsten Niveau</translation>
    </message>
    <message>
        <source>is not after from_day</source>
        <translation>liegt nicht nach from_day</translation>
    </message>
    <message>
        <source>is not allowed</source>
        <translation>ist nicht erlaubt</translation>
    </message>
    <message>
        <source>is not positive</source>
        <translation>ist nicht positiv</translation>
    </message>
    <message>
        <source>is not protected: it has no accounts</source>
        <translation>ist nicht geschützt und hat keine Konten</translation>
    </message>
    <message>
        <source>is nothing that this kind of task has</source>
        <translation>hat diese Art von Aufgabe nicht</translation>
    </message>
    <message>
        <source>is or was the name of an account</source>
        <translation>ist oder war der Name eines Kontos</translation>
    </message>
    <message>
        <source>is out of range</source>
        <translation>liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>is protected, and nobody is logged in</source>
        <translation>ist geschützt, und niemand ist angemeldet</translation>
    </message>
    <message>
        <source>is read-only</source>
        <translation>ist schreibgeschützt</translation>
    </message>
    <message>
        <source>is shipped and stays as it is</source>
        <translation>wird mitgeliefert und bleibt, wie es ist</translation>
    </message>
    <message>
        <source>is the backup itself</source>
        <translation>ist die Sicherung selbst</translation>
    </message>
    <message>
        <source>is the input: it would be lost</source>
        <translation>ist die Eingabe: Sie ginge verloren</translation>
    </message>
    <message>
        <source>is the name of %1</source>
        <translation>ist der Name von %1</translation>
    </message>
    <message>
        <source>is too easy to guess</source>
        <translation>ist zu leicht zu erraten</translation>
    </message>
    <message>
        <source>is too large in SI units</source>
        <translation>ist in SI-Einheiten zu groß</translation>
    </message>
    <message>
        <source>is too slow</source>
        <translation>ist zu langsam</translation>
    </message>
    <message>
        <source>the PIN is wrong</source>
        <translation>die PIN ist falsch</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>ist null</translation>
    </message>
    <message>
        <source>is zero or along the normal</source>
        <translation>ist null oder liegt entlang der Normalen</translation>
    </message>
    <message>
        <source>it does not answer in time</source>
        <translation>es antwortet nicht rechtzeitig</translation>
    </message>
    <message>
        <source>it holds no force</source>
        <translation>sie enthält keine Kraft</translation>
    </message>
    <message>
        <source>it holds no path of an object</source>
        <translation>sie enthält keinen Weg eines Objekts</translation>
    </message>
    <message>
        <source>it refuses the connection</source>
        <translation>es verweigert die Verbindung</translation>
    </message>
    <message>
        <source>it says itself that calibration slot %1 is bad</source>
        <translation>er sagt selbst, dass Kalibrierplatz %1 nicht in Ordnung ist</translation>
    </message>
    <message>
        <source>it says that its sensor is not initialised</source>
        <translation>er sagt, dass sein Sensor nicht initialisiert ist</translation>
    </message>
    <message>
        <source>its error code is %1</source>
        <translation>sein Fehlercode ist %1</translation>
    </message>
    <message>
        <source>its first line is empty</source>
        <translation>ihre erste Zeile ist leer</translation>
    </message>
    <message>
        <source>its first line is too long</source>
        <translation>ihre erste Zeile ist zu lang</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>der Ordner dazu fehlt</translation>
    </message>
    <message>
        <source>its folder is read-only</source>
        <translation>der Ordner dazu ist schreibgeschützt</translation>
    </message>
    <message>
        <source>its own factor is not between 0.5 and 2: this is no correction</source>
        <translation>der eigene Faktor liegt nicht zwischen 0.5 und 2: Das ist keine Korrektur</translation>
    </message>
    <message>
        <source>keep bandwidth times duration below %1</source>
        <translation>Bandbreite mal Dauer unter %1 halten</translation>
    </message>
    <message>
        <source>keep it on a local disk</source>
        <translation>sie auf einem lokalen Datenträger halten</translation>
    </message>
    <message>
        <source>keep one contact per finger</source>
        <translation>einen Kontakt je Finger behalten</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>eines davon behalten</translation>
    </message>
    <message>
        <source>keep the database on a local disk</source>
        <translation>die Datenbank auf einem lokalen Datenträger halten</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>key or closing &apos;}&apos;</source>
        <translation>Schlüssel oder „}“</translation>
    </message>
    <message>
        <source>key-value pair</source>
        <translation>Schlüssel mit Wert</translation>
    </message>
    <message>
        <source>key-value pair or closing &apos;}&apos;</source>
        <translation>Schlüssel mit Wert oder „}“</translation>
    </message>
    <message>
        <source>keys, tables, whitespace or comments</source>
        <translation>Schlüssel, Tabellen, Leerraum oder Kommentare</translation>
    </message>
    <message>
        <source>leading zeroes are prohibited</source>
        <translation>führende Nullen sind nicht erlaubt</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>weglassen</translation>
    </message>
    <message>
        <source>leave it out; the guided check finds exchanged sensors</source>
        <translation>weglassen; die geführte Prüfung findet vertauschte Sensoren</translation>
    </message>
    <message>
        <source>leave out --fast</source>
        <translation>--fast weglassen</translation>
    </message>
    <message>
        <source>leave out --fast, or use sim:// or replay://</source>
        <translation>--fast weglassen oder sim:// oder replay:// verwenden</translation>
    </message>
    <message>
        <source>leave out wrenches that almost coincide</source>
        <translation>Kräfte weglassen, die fast zusammenfallen</translation>
    </message>
    <message>
        <source>leave protocol out or use another configuration</source>
        <translation>protocol weglassen oder eine andere Konfiguration verwenden</translation>
    </message>
    <message>
        <source>leave the login out</source>
        <translation>die Anmeldung weglassen</translation>
    </message>
    <message>
        <source>leave the task out, or repeat the screening</source>
        <translation>die Aufgabe weglassen oder die Vorab-Fragen wiederholen</translation>
    </message>
    <message>
        <source>leave the value out and give the reason</source>
        <translation>den Wert weglassen und den Grund angeben</translation>
    </message>
    <message>
        <source>leave this person out, or record the consent that was given</source>
        <translation>diese Person weglassen oder die gegebene Einwilligung eintragen</translation>
    </message>
    <message>
        <source>leaves no time within time_limit_s</source>
        <translation>lässt innerhalb von time_limit_s keine Zeit</translation>
    </message>
    <message>
        <source>left</source>
        <translation>linke</translation>
    </message>
    <message>
        <source>let the target turn about rx, ry or rz alone</source>
        <translation>das Ziel nur um rx, ry oder rz drehen lassen</translation>
    </message>
    <message>
        <source>libsodium does not start</source>
        <translation>libsodium startet nicht</translation>
    </message>
    <message>
        <source>lift the restriction if the person wishes to go on</source>
        <translation>die Beschränkung aufheben, wenn die Person weitermachen möchte</translation>
    </message>
    <message>
        <source>lifting a restriction</source>
        <translation>Beschränkung aufheben</translation>
    </message>
    <message>
        <source>literal string</source>
        <translation>Text in einfachen Anführungszeichen</translation>
    </message>
    <message>
        <source>log in again</source>
        <translation>neu anmelden</translation>
    </message>
    <message>
        <source>log in as a therapist</source>
        <translation>als Therapeut anmelden</translation>
    </message>
    <message>
        <source>log in as an administrator</source>
        <translation>als Administrator anmelden</translation>
    </message>
    <message>
        <source>log in as somebody else</source>
        <translation>als jemand anderes anmelden</translation>
    </message>
    <message>
        <source>log in with a name</source>
        <translation>mit einem Namen anmelden</translation>
    </message>
    <message>
        <source>log in with the password</source>
        <translation>mit dem Passwort anmelden</translation>
    </message>
    <message>
        <source>logging in</source>
        <translation>Anmeldung</translation>
    </message>
    <message>
        <source>look at its measures</source>
        <translation>die Messgrößen ansehen</translation>
    </message>
    <message>
        <source>make it shorter</source>
        <translation>kürzer machen</translation>
    </message>
    <message>
        <source>make it shorter, or repeat it less often</source>
        <translation>kürzer machen oder seltener wiederholen</translation>
    </message>
    <message>
        <source>make it with isograsp db init, or check the path</source>
        <translation>mit isograsp db init anlegen oder den Pfad prüfen</translation>
    </message>
    <message>
        <source>make it writable, or copy it to where you may write</source>
        <translation>beschreibbar machen oder dorthin kopieren, wo Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>make its folder writable</source>
        <translation>den Ordner dazu beschreibbar machen</translation>
    </message>
    <message>
        <source>make the folder</source>
        <translation>den Ordner anlegen</translation>
    </message>
    <message>
        <source>make the folder %1</source>
        <translation>den Ordner %1 anlegen</translation>
    </message>
    <message>
        <source>make the folder writable</source>
        <translation>den Ordner beschreibbar machen</translation>
    </message>
    <message>
        <source>make the folder writable, or copy the file to where you may write</source>
        <translation>den Ordner beschreibbar machen oder die Datei dorthin kopieren, wo Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>make them all different</source>
        <translation>alle verschieden machen</translation>
    </message>
    <message>
        <source>making the database</source>
        <translation>Datenbank anlegen</translation>
    </message>
    <message>
        <source>making the database: %1</source>
        <translation>Datenbank anlegen: %1</translation>
    </message>
    <message>
        <source>map every finger once</source>
        <translation>jeden Finger einmal zuordnen</translation>
    </message>
    <message>
        <source>marking a trial</source>
        <translation>Versuch kennzeichnen</translation>
    </message>
    <message>
        <source>marking interrupted trials</source>
        <translation>unterbrochene Versuche kennzeichnen</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>maximum force</source>
        <translation>Maximalkraft</translation>
    </message>
    <message>
        <source>may not be read</source>
        <translation>darf nicht gelesen werden</translation>
    </message>
    <message>
        <source>measure %1 is not a finite number</source>
        <translation>die Messgröße %1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>measure today&apos;s maximum, or use the task relative to it</source>
        <translation>das heutige Maximum messen oder die Aufgabe relativ zu ihm verwenden</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mittelfinger</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>missing exponent</source>
        <translation>der Exponent fehlt</translation>
    </message>
    <message>
        <source>move it while it is recorded</source>
        <translation>es während der Aufnahme bewegen</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>eine Datei nennen</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>eine Datei darin nennen</translation>
    </message>
    <message>
        <source>name a new file</source>
        <translation>eine neue Datei nennen</translation>
    </message>
    <message>
        <source>name at least one digit</source>
        <translation>mindestens einen Finger nennen</translation>
    </message>
    <message>
        <source>name at least one direction</source>
        <translation>mindestens eine Richtung nennen</translation>
    </message>
    <message>
        <source>name at least one task</source>
        <translation>mindestens eine Aufgabe nennen</translation>
    </message>
    <message>
        <source>name every column</source>
        <translation>jede Spalte benennen</translation>
    </message>
    <message>
        <source>name it like thumb_fx_N or thumb_tx_Nm, or remove it</source>
        <translation>sie wie thumb_fx_N oder thumb_tx_Nm nennen oder entfernen</translation>
    </message>
    <message>
        <source>name or password is wrong</source>
        <translation>Name oder Passwort ist falsch</translation>
    </message>
    <message>
        <source>name the card that the driver jr3_pci serves</source>
        <translation>die Karte nennen, die der Treiber jr3_pci bedient</translation>
    </message>
    <message>
        <source>name the columns t_s and target</source>
        <translation>die Spalten t_s und target nennen</translation>
    </message>
    <message>
        <source>name the measure</source>
        <translation>die Messgröße nennen</translation>
    </message>
    <message>
        <source>name the task</source>
        <translation>die Aufgabe nennen</translation>
    </message>
    <message>
        <source>name those that have a column X_fz_N</source>
        <translation>die nennen, die eine Spalte X_fz_N haben</translation>
    </message>
    <message>
        <source>name two files</source>
        <translation>zwei Dateien nennen</translation>
    </message>
    <message>
        <source>names no column</source>
        <translation>nennt keine Spalte</translation>
    </message>
    <message>
        <source>needs at least 2 levels of each factor</source>
        <translation>braucht mindestens 2 Stufen jedes Faktors</translation>
    </message>
    <message>
        <source>neither 1 nor -1</source>
        <translation>weder 1 noch -1</translation>
    </message>
    <message>
        <source>no body has one principal moment alone: each is at most the sum of the others</source>
        <translation>kein Körper hat nur ein Hauptträgheitsmoment: Jedes ist höchstens die Summe der anderen</translation>
    </message>
    <message>
        <source>no convex hull of these wrenches: %1</source>
        <translation>keine konvexe Hülle dieser Kräfte: %1</translation>
    </message>
    <message>
        <source>no database file is given</source>
        <translation>keine Datenbankdatei ist angegeben</translation>
    </message>
    <message>
        <source>no datagram of this log holds records of a Net F/T box</source>
        <translation>kein Datagramm dieses Mitschnitts enthält Messdaten einer Net-F/T-Box</translation>
    </message>
    <message>
        <source>no device is called %1://</source>
        <translation>kein Gerät heißt %1://</translation>
    </message>
    <message>
        <source>no file for the backup is given</source>
        <translation>keine Datei für die Sicherung ist angegeben</translation>
    </message>
    <message>
        <source>no file is named</source>
        <translation>keine Datei ist genannt</translation>
    </message>
    <message>
        <source>no finger is mapped</source>
        <translation>kein Finger ist zugeordnet</translation>
    </message>
    <message>
        <source>no interface is named</source>
        <translation>keine Schnittstelle ist genannt</translation>
    </message>
    <message>
        <source>no patient is named</source>
        <translation>kein Patient ist genannt</translation>
    </message>
    <message>
        <source>no protocol is called &apos;%1&apos;</source>
        <translation>kein Protokoll heißt „%1“</translation>
    </message>
    <message>
        <source>no row id</source>
        <translation>keine Zeilennummer</translation>
    </message>
    <message>
        <source>nobody has an account of this name</source>
        <translation>niemand hat ein Konto dieses Namens</translation>
    </message>
    <message>
        <source>nobody has opened the database with a password yet</source>
        <translation>noch niemand hat die Datenbank mit einem Passwort geöffnet</translation>
    </message>
    <message>
        <source>nobody is logged in with an account</source>
        <translation>niemand ist mit einem Konto angemeldet</translation>
    </message>
    <message>
        <source>nobody presses the simulated device</source>
        <translation>niemand drückt auf das simulierte Gerät</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>Knoten %1</translation>
    </message>
    <message>
        <source>normal and tangent do not span a plane</source>
        <translation>normal und tangent spannen keine Ebene auf</translation>
    </message>
    <message>
        <source>not a device URI</source>
        <translation>keine Geräte-URI</translation>
    </message>
    <message>
        <source>not a finite wrench</source>
        <translation>keine endlichen Kräfte</translation>
    </message>
    <message>
        <source>not a parameter of the form key=value</source>
        <translation>kein Parameter der Form key=value</translation>
    </message>
    <message>
        <source>not a time in seconds with 6 or 9 fraction digits</source>
        <translation>keine Zeit in Sekunden mit 6 oder 9 Nachkommastellen</translation>
    </message>
    <message>
        <source>not above first_id: the bus could turn a pair of frames around</source>
        <translation>nicht größer als first_id: Der Bus könnte zwei Telegramme vertauschen</translation>
    </message>
    <message>
        <source>not an IPv4 address with a port</source>
        <translation>keine IPv4-Adresse mit Port</translation>
    </message>
    <message>
        <source>not an address in numbers</source>
        <translation>keine Adresse in Zahlen</translation>
    </message>
    <message>
        <source>not an identifier of this sensor family</source>
        <translation>keine Kennung dieser Sensorfamilie</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>nicht genug Arbeitsspeicher</translation>
    </message>
    <message>
        <source>not enough memory for the key of a password</source>
        <translation>nicht genug Arbeitsspeicher für den Schlüssel eines Passworts</translation>
    </message>
    <message>
        <source>not positive</source>
        <translation>nicht positiv</translation>
    </message>
    <message>
        <source>not the addresses of three sensors</source>
        <translation>nicht die Adressen von drei Sensoren</translation>
    </message>
    <message>
        <source>not valid TOML: %1</source>
        <translation>kein gültiges TOML: %1</translation>
    </message>
    <message>
        <source>not whole bytes of two hexadecimal digits</source>
        <translation>keine ganzen Bytes aus zwei hexadezimalen Ziffern</translation>
    </message>
    <message>
        <source>one of its full scales is not positive</source>
        <translation>einer seiner Messbereiche ist nicht positiv</translation>
    </message>
    <message>
        <source>one of its full scales is zero</source>
        <translation>einer seiner Messbereiche ist null</translation>
    </message>
    <message>
        <source>only what is held can be let go</source>
        <translation>nur was gehalten wird, kann losgelassen werden</translation>
    </message>
    <message>
        <source>open it in a session, which brings the simulated patient</source>
        <translation>in einer Sitzung öffnen, die den simulierten Patienten mitbringt</translation>
    </message>
    <message>
        <source>open the box&apos;s web page and check its configuration</source>
        <translation>die Webseite der Box öffnen und ihre Konfiguration prüfen</translation>
    </message>
    <message>
        <source>overlaps the stable time from %1 to %2</source>
        <translation>überschneidet sich mit der stabilen Zeit von %1 bis %2</translation>
    </message>
    <message>
        <source>packing signals</source>
        <translation>Signale packen</translation>
    </message>
    <message>
        <source>patient %1 exists already</source>
        <translation>den Patienten %1 gibt es schon</translation>
    </message>
    <message>
        <source>patient %1 was erased: the code is not given again</source>
        <translation>der Patient %1 wurde gelöscht: Der Code wird nicht noch einmal vergeben</translation>
    </message>
    <message>
        <source>patient code</source>
        <translation>Patientencode</translation>
    </message>
    <message>
        <source>plug in the CAN adapter and load its driver</source>
        <translation>den CAN-Adapter einstecken und seinen Treiber laden</translation>
    </message>
    <message>
        <source>plug in the adapter and check the name of the port</source>
        <translation>den Adapter einstecken und den Namen des Anschlusses prüfen</translation>
    </message>
    <message>
        <source>plug in the network cable and give this computer an address in the same network</source>
        <translation>das Netzwerkkabel einstecken und diesem Rechner eine Adresse im selben Netz geben</translation>
    </message>
    <message>
        <source>press while it is recorded</source>
        <translation>während der Aufnahme drücken</translation>
    </message>
    <message>
        <source>primary measure</source>
        <translation>Hauptmessgröße</translation>
    </message>
    <message>
        <source>program the sensor so that first_id is the smaller one</source>
        <translation>den Sensor so programmieren, dass first_id die kleinere ist</translation>
    </message>
    <message>
        <source>protecting the database</source>
        <translation>Datenbank schützen</translation>
    </message>
    <message>
        <source>put a resting-force task before it</source>
        <translation>davor eine Ruhekraft-Aufgabe einfügen</translation>
    </message>
    <message>
        <source>put a task that measures it before</source>
        <translation>davor eine Aufgabe einfügen, die sie misst</translation>
    </message>
    <message>
        <source>put it into %1</source>
        <translation>sie in %1 ablegen</translation>
    </message>
    <message>
        <source>put the file beside the task</source>
        <translation>die Datei neben die Aufgabe legen</translation>
    </message>
    <message>
        <source>raise it, or make the target longer</source>
        <translation>erhöhen oder das Ziel verlängern</translation>
    </message>
    <message>
        <source>read what there is again</source>
        <translation>neu lesen, was vorhanden ist</translation>
    </message>
    <message>
        <source>reading a code</source>
        <translation>Code lesen</translation>
    </message>
    <message>
        <source>reading a consent</source>
        <translation>Einwilligung lesen</translation>
    </message>
    <message>
        <source>reading a profile</source>
        <translation>Profil lesen</translation>
    </message>
    <message>
        <source>reading accounts</source>
        <translation>Konten lesen</translation>
    </message>
    <message>
        <source>reading an identity</source>
        <translation>Identität lesen</translation>
    </message>
    <message>
        <source>reading answers</source>
        <translation>Antworten lesen</translation>
    </message>
    <message>
        <source>reading clinical scores</source>
        <translation>klinische Werte lesen</translation>
    </message>
    <message>
        <source>reading consents</source>
        <translation>Einwilligungen lesen</translation>
    </message>
    <message>
        <source>reading erased codes</source>
        <translation>gelöschte Codes lesen</translation>
    </message>
    <message>
        <source>reading events</source>
        <translation>Ereignisse lesen</translation>
    </message>
    <message>
        <source>reading identities</source>
        <translation>Identitäten lesen</translation>
    </message>
    <message>
        <source>reading instrument zeros</source>
        <translation>Nullabgleiche lesen</translation>
    </message>
    <message>
        <source>reading measures</source>
        <translation>Messgrößen lesen</translation>
    </message>
    <message>
        <source>reading patients</source>
        <translation>Patienten lesen</translation>
    </message>
    <message>
        <source>reading primary measures</source>
        <translation>Hauptmessgrößen lesen</translation>
    </message>
    <message>
        <source>reading progress</source>
        <translation>Verlauf lesen</translation>
    </message>
    <message>
        <source>reading ratings</source>
        <translation>Bewertungen lesen</translation>
    </message>
    <message>
        <source>reading resting forces</source>
        <translation>Ruhekräfte lesen</translation>
    </message>
    <message>
        <source>reading sessions</source>
        <translation>Sitzungen lesen</translation>
    </message>
    <message>
        <source>reading stable times</source>
        <translation>stabile Zeiten lesen</translation>
    </message>
    <message>
        <source>reading the audit log</source>
        <translation>Zugriffsprotokoll lesen</translation>
    </message>
    <message>
        <source>reading the last instrument zero</source>
        <translation>letzten Nullabgleich lesen</translation>
    </message>
    <message>
        <source>reading the newest sessions</source>
        <translation>neueste Sitzungen lesen</translation>
    </message>
    <message>
        <source>reading the policy</source>
        <translation>Richtlinie lesen</translation>
    </message>
    <message>
        <source>reading treatment marks</source>
        <translation>Behandlungen lesen</translation>
    </message>
    <message>
        <source>reading trials</source>
        <translation>Versuche lesen</translation>
    </message>
    <message>
        <source>reading values of other people</source>
        <translation>Werte anderer Personen lesen</translation>
    </message>
    <message>
        <source>real time is required, but the system gives %1</source>
        <translation>Echtzeit ist verlangt, das System gibt aber %1</translation>
    </message>
    <message>
        <source>record it again, slower</source>
        <translation>langsamer noch einmal aufnehmen</translation>
    </message>
    <message>
        <source>record one</source>
        <translation>eine aufnehmen</translation>
    </message>
    <message>
        <source>record raw frames of a bus only</source>
        <translation>Rohtelegramme nur von einem Bus aufzeichnen</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>entfernen</translation>
    </message>
    <message>
        <source>remove it or correct its spelling</source>
        <translation>entfernen oder die Schreibweise berichtigen</translation>
    </message>
    <message>
        <source>remove one of them first</source>
        <translation>zuerst eine davon entfernen</translation>
    </message>
    <message>
        <source>remove that one first, or give other days</source>
        <translation>zuerst jene entfernen oder andere Tage angeben</translation>
    </message>
    <message>
        <source>remove the limit, or align springs and dampers with the world</source>
        <translation>die Grenze entfernen oder Federn und Dämpfer an der Welt ausrichten</translation>
    </message>
    <message>
        <source>remove the limit, or free one rotation only</source>
        <translation>die Grenze entfernen oder nur eine Drehung freigeben</translation>
    </message>
    <message>
        <source>removing a clinical score</source>
        <translation>klinischen Wert entfernen</translation>
    </message>
    <message>
        <source>removing a primary measure</source>
        <translation>Hauptmessgröße entfernen</translation>
    </message>
    <message>
        <source>removing a stable time</source>
        <translation>stabile Zeit entfernen</translation>
    </message>
    <message>
        <source>removing a treatment mark</source>
        <translation>Behandlung entfernen</translation>
    </message>
    <message>
        <source>removing an account</source>
        <translation>Konto entfernen</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>rename that one, or take this one from %1</source>
        <translation>jene umbenennen oder diese aus %1 holen</translation>
    </message>
    <message>
        <source>resample the files to one time axis first</source>
        <translation>die Dateien zuerst auf eine Zeitachse bringen</translation>
    </message>
    <message>
        <source>researcher</source>
        <translation>Forscher</translation>
    </message>
    <message>
        <source>restore the last backup</source>
        <translation>die letzte Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>restore the last backup; other trials can still be read</source>
        <translation>die letzte Sicherung wiederherstellen; andere Versuche sind weiter lesbar</translation>
    </message>
    <message>
        <source>restricting records</source>
        <translation>Aufzeichnungen beschränken</translation>
    </message>
    <message>
        <source>rewriting the file</source>
        <translation>Datei neu schreiben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>root table</source>
        <translation>oberste Tabelle</translation>
    </message>
    <message>
        <source>run isograsp db check</source>
        <translation>isograsp db check ausführen</translation>
    </message>
    <message>
        <source>run isograsp db check, then restore the last backup</source>
        <translation>isograsp db check ausführen, dann die letzte Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>run isograsp db migrate on it; a copy of the file as it is now is kept</source>
        <translation>isograsp db migrate darauf ausführen; eine Kopie der jetzigen Datei bleibt erhalten</translation>
    </message>
    <message>
        <source>run: sudo ip link set %1 up type can bitrate 1000000 restart-ms 100</source>
        <translation>ausführen: sudo ip link set %1 up type can bitrate 1000000 restart-ms 100</translation>
    </message>
    <message>
        <source>say completed or aborted</source>
        <translation>„completed“ oder „aborted“ angeben</translation>
    </message>
    <message>
        <source>say what was asked</source>
        <translation>angeben, was gefragt wurde</translation>
    </message>
    <message>
        <source>say what was asked about</source>
        <translation>angeben, wonach gefragt wurde</translation>
    </message>
    <message>
        <source>say which clinician judged the person stable</source>
        <translation>angeben, wer die Person als stabil beurteilt hat</translation>
    </message>
    <message>
        <source>say who chose the measure</source>
        <translation>angeben, wer die Messgröße gewählt hat</translation>
    </message>
    <message>
        <source>say with --config which three are under the fingers</source>
        <translation>mit --config angeben, welche drei unter den Fingern sind</translation>
    </message>
    <message>
        <source>scale the target to 0 … 1</source>
        <translation>das Ziel auf 0 … 1 skalieren</translation>
    </message>
    <message>
        <source>second %1 came instead of %2</source>
        <translation>Sekunde %1 kam statt %2</translation>
    </message>
    <message>
        <source>second %1 holds %2 rows, more than one second</source>
        <translation>Sekunde %1 enthält %2 Zeilen, mehr als eine Sekunde</translation>
    </message>
    <message>
        <source>see isograsp db users list</source>
        <translation>siehe isograsp db users list</translation>
    </message>
    <message>
        <source>see: isograsp devices</source>
        <translation>siehe: isograsp devices</translation>
    </message>
    <message>
        <source>sends at %1 Hz, not at %2</source>
        <translation>sendet mit %1 Hz, nicht mit %2</translation>
    </message>
    <message>
        <source>serial lines</source>
        <translation>seriellen Anschlüssen</translation>
    </message>
    <message>
        <source>set it to 0, or free %1</source>
        <translation>auf 0 setzen oder %1 freigeben</translation>
    </message>
    <message>
        <source>set the tool transformation to zero on the box&apos;s page Configurations</source>
        <translation>die Werkzeugtransformation auf der Seite Configurations der Box auf null setzen</translation>
    </message>
    <message>
        <source>shifts or turns its forces before it sends them</source>
        <translation>verschiebt oder dreht seine Kräfte, bevor er sie sendet</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>kürzen</translation>
    </message>
    <message>
        <source>signal group &apos;%1&apos; has no columns or one without a name</source>
        <translation>die Signalgruppe „%1“ hat keine Spalten oder eine ohne Namen</translation>
    </message>
    <message>
        <source>sort the rows and remove repeats</source>
        <translation>die Zeilen sortieren und Wiederholungen entfernen</translation>
    </message>
    <message>
        <source>sort the times</source>
        <translation>die Zeiten sortieren</translation>
    </message>
    <message>
        <source>stable time</source>
        <translation>stabile Zeit</translation>
    </message>
    <message>
        <source>stands in a read-only folder</source>
        <translation>liegt in einem schreibgeschützten Ordner</translation>
    </message>
    <message>
        <source>start from an attitude about the free axes, or free more rotations</source>
        <translation>von einer Lage um die freien Achsen ausgehen oder mehr Drehungen freigeben</translation>
    </message>
    <message>
        <source>start inside the limit, or widen it</source>
        <translation>innerhalb der Grenze beginnen oder sie erweitern</translation>
    </message>
    <message>
        <source>start it from a desktop, or run a session without windows: isograsp run</source>
        <translation>auf einem Desktop starten oder eine Sitzung ohne Fenster ausführen: isograsp run</translation>
    </message>
    <message>
        <source>starts outside the limit of %1</source>
        <translation>beginnt außerhalb der Grenze von %1</translation>
    </message>
    <message>
        <source>starts outside the limit of the rotation</source>
        <translation>beginnt außerhalb der Grenze der Drehung</translation>
    </message>
    <message>
        <source>storing a PIN</source>
        <translation>PIN speichern</translation>
    </message>
    <message>
        <source>storing a clinical score</source>
        <translation>klinischen Wert speichern</translation>
    </message>
    <message>
        <source>storing a consent</source>
        <translation>Einwilligung speichern</translation>
    </message>
    <message>
        <source>storing a password</source>
        <translation>Passwort speichern</translation>
    </message>
    <message>
        <source>storing a primary measure</source>
        <translation>Hauptmessgröße speichern</translation>
    </message>
    <message>
        <source>storing a profile</source>
        <translation>Profil speichern</translation>
    </message>
    <message>
        <source>storing a rating</source>
        <translation>Bewertung speichern</translation>
    </message>
    <message>
        <source>storing a recovery key</source>
        <translation>Wiederherstellungsschlüssel speichern</translation>
    </message>
    <message>
        <source>storing a resting force</source>
        <translation>Ruhekraft speichern</translation>
    </message>
    <message>
        <source>storing a second of signals</source>
        <translation>eine Sekunde Signale speichern</translation>
    </message>
    <message>
        <source>storing a stable time</source>
        <translation>stabile Zeit speichern</translation>
    </message>
    <message>
        <source>storing a treatment mark</source>
        <translation>Behandlung speichern</translation>
    </message>
    <message>
        <source>storing an event</source>
        <translation>Ereignis speichern</translation>
    </message>
    <message>
        <source>storing an identity</source>
        <translation>Identität speichern</translation>
    </message>
    <message>
        <source>storing an instrument zero</source>
        <translation>Nullabgleich speichern</translation>
    </message>
    <message>
        <source>storing answers</source>
        <translation>Antworten speichern</translation>
    </message>
    <message>
        <source>storing the passphrase</source>
        <translation>Passphrase speichern</translation>
    </message>
    <message>
        <source>storing the policy</source>
        <translation>Richtlinie speichern</translation>
    </message>
    <message>
        <source>string</source>
        <translation>Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>subdevice %1</source>
        <translation>Untergerät %1</translation>
    </message>
    <message>
        <source>subdevice %1 is no JR3 sensor</source>
        <translation>Untergerät %1 ist kein JR3-Sensor</translation>
    </message>
    <message>
        <source>table header</source>
        <translation>Kopf einer Tabelle</translation>
    </message>
    <message>
        <source>tables with blank bare keys are explicitly prohibited</source>
        <translation>Tabellen ohne Namen sind nicht erlaubt</translation>
    </message>
    <message>
        <source>take an older backup</source>
        <translation>eine ältere Sicherung nehmen</translation>
    </message>
    <message>
        <source>takes longer than two hours</source>
        <translation>dauert länger als zwei Stunden</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>text after the bytes of the datagram</source>
        <translation>Text hinter den Bytes des Datagramms</translation>
    </message>
    <message>
        <source>text after the frame that is not R or T</source>
        <translation>Text hinter dem Telegramm, der nicht R oder T ist</translation>
    </message>
    <message>
        <source>the CAN interface cannot be opened: %1</source>
        <translation>die CAN-Schnittstelle kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>the CAN interface is switched off</source>
        <translation>die CAN-Schnittstelle ist ausgeschaltet</translation>
    </message>
    <message>
        <source>the address of a sensor is missing</source>
        <translation>die Adresse eines Sensors fehlt</translation>
    </message>
    <message>
        <source>the backup is not sound: %1</source>
        <translation>die Sicherung ist nicht in Ordnung: %1</translation>
    </message>
    <message>
        <source>the block is %1</source>
        <translation>der Block ist %1</translation>
    </message>
    <message>
        <source>the box of the %1 has the address &apos;%2&apos;, which is not in numbers</source>
        <translation>die Box des Fingers (%1) hat die Adresse „%2“, die nicht in Zahlen ist</translation>
    </message>
    <message>
        <source>the box&apos;s page does not have this element</source>
        <translation>die Seite der Box hat dieses Element nicht</translation>
    </message>
    <message>
        <source>the box&apos;s page has more than a short text here</source>
        <translation>die Seite der Box hat hier mehr als einen kurzen Text</translation>
    </message>
    <message>
        <source>the box&apos;s page has this element twice</source>
        <translation>die Seite der Box hat dieses Element zweimal</translation>
    </message>
    <message>
        <source>the bus failed while the sensors were started: %1</source>
        <translation>der Bus fiel aus, während die Sensoren gestartet wurden: %1</translation>
    </message>
    <message>
        <source>the calibration was made with sensor %1, but this one is %2</source>
        <translation>die Kalibrierung wurde mit Sensor %1 gemacht, dieser ist aber %2</translation>
    </message>
    <message>
        <source>the card cannot be opened: %1</source>
        <translation>die Karte kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>the card has no subdevice %1</source>
        <translation>die Karte hat kein Untergerät %1</translation>
    </message>
    <message>
        <source>the column appears twice</source>
        <translation>die Spalte kommt zweimal vor</translation>
    </message>
    <message>
        <source>the column is missing</source>
        <translation>die Spalte fehlt</translation>
    </message>
    <message>
        <source>the configuration is for %1</source>
        <translation>die Konfiguration ist für %1</translation>
    </message>
    <message>
        <source>the copy could not be written</source>
        <translation>die Kopie konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the copy is not sound: %1</source>
        <translation>die Kopie ist nicht in Ordnung: %1</translation>
    </message>
    <message>
        <source>the cut-off is not below half the rate</source>
        <translation>die Grenzfrequenz liegt nicht unter der halben Rate</translation>
    </message>
    <message>
        <source>the database cannot be set to durable writing</source>
        <translation>die Datenbank lässt sich nicht auf sicheres Schreiben einstellen</translation>
    </message>
    <message>
        <source>the day of the last record of %1 cannot be read</source>
        <translation>der Tag der letzten Aufzeichnung von %1 kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the device answers with HTTP status %1</source>
        <translation>das Gerät antwortet mit HTTP-Status %1</translation>
    </message>
    <message>
        <source>the device cannot be asked: %1</source>
        <translation>das Gerät kann nicht gefragt werden: %1</translation>
    </message>
    <message>
        <source>the device cannot be reached: %1</source>
        <translation>das Gerät kann nicht erreicht werden: %1</translation>
    </message>
    <message>
        <source>the device has no raw frames</source>
        <translation>das Gerät hat keine Rohtelegramme</translation>
    </message>
    <message>
        <source>the device is set up for the %1 hand, the session for the %2</source>
        <translation>das Gerät ist für die %1 Hand eingerichtet, die Sitzung für die %2</translation>
    </message>
    <message>
        <source>the device&apos;s answer cannot be read: %1</source>
        <translation>die Antwort des Geräts kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>the field is empty while others of this finger are not</source>
        <translation>das Feld ist leer, andere dieses Fingers sind es nicht</translation>
    </message>
    <message>
        <source>the file cannot be brought back: %1</source>
        <translation>die Datei kann nicht zurückgeholt werden: %1</translation>
    </message>
    <message>
        <source>the file cannot be put away: %1</source>
        <translation>die Datei kann nicht weggelegt werden: %1</translation>
    </message>
    <message>
        <source>the finger has two sensors</source>
        <translation>der Finger hat zwei Sensoren</translation>
    </message>
    <message>
        <source>the fixed load of %1 N is above half of today&apos;s maximum, or that was not measured</source>
        <translation>die feste Last von %1 N liegt über der Hälfte des heutigen Maximums, oder dieses wurde nicht gemessen</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>der Ordner kann nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>the force changed by less than 0.5 N</source>
        <translation>die Kraft hat sich um weniger als 0.5 N geändert</translation>
    </message>
    <message>
        <source>the force turns with the object while springs or dampers stand at an angle to the world&apos;s axes</source>
        <translation>die Kraft dreht sich mit dem Objekt, während Federn oder Dämpfer schräg zu den Achsen der Welt stehen</translation>
    </message>
    <message>
        <source>the frame period is not positive</source>
        <translation>die Bildperiode ist nicht positiv</translation>
    </message>
    <message>
        <source>the free rotations cannot reach this attitude</source>
        <translation>die freien Drehungen erreichen diese Lage nicht</translation>
    </message>
    <message>
        <source>the groups of second %1 do not hold the same number of whole rows</source>
        <translation>die Gruppen von Sekunde %1 enthalten nicht gleich viele ganze Zeilen</translation>
    </message>
    <message>
        <source>the header has an empty column name</source>
        <translation>die Kopfzeile hat einen leeren Spaltennamen</translation>
    </message>
    <message>
        <source>the identity of %1 was changed or is damaged</source>
        <translation>die Identität von %1 wurde geändert oder ist beschädigt</translation>
    </message>
    <message>
        <source>the index finger&apos;s sensor (%1)</source>
        <translation>der Sensor des Zeigefingers (%1)</translation>
    </message>
    <message>
        <source>the index&apos;s sensor</source>
        <translation>der Sensor des Zeigefingers</translation>
    </message>
    <message>
        <source>the last session finished its protocol</source>
        <translation>die letzte Sitzung hat ihr Protokoll beendet</translation>
    </message>
    <message>
        <source>the last session of this hand began more than four hours ago</source>
        <translation>die letzte Sitzung dieser Hand begann vor mehr als vier Stunden</translation>
    </message>
    <message>
        <source>the last session of this hand followed the protocol &apos;%1&apos;, or another version of this one</source>
        <translation>die letzte Sitzung dieser Hand folgte dem Protokoll „%1“ oder einer anderen Fassung von diesem</translation>
    </message>
    <message>
        <source>the limit has no bound</source>
        <translation>die Grenze hat kein Ende</translation>
    </message>
    <message>
        <source>the line does not begin with a time in parentheses</source>
        <translation>die Zeile beginnt nicht mit einer Zeit in Klammern</translation>
    </message>
    <message>
        <source>the line ends before the bytes of the datagram</source>
        <translation>die Zeile endet vor den Bytes des Datagramms</translation>
    </message>
    <message>
        <source>the line ends before the frame</source>
        <translation>die Zeile endet vor dem Telegramm</translation>
    </message>
    <message>
        <source>the line ends before this column</source>
        <translation>die Zeile endet vor dieser Spalte</translation>
    </message>
    <message>
        <source>the line has more fields than the header</source>
        <translation>die Zeile hat mehr Felder als die Kopfzeile</translation>
    </message>
    <message>
        <source>the middle finger&apos;s sensor (%1)</source>
        <translation>der Sensor des Mittelfingers (%1)</translation>
    </message>
    <message>
        <source>the middle&apos;s sensor</source>
        <translation>der Sensor des Mittelfingers</translation>
    </message>
    <message>
        <source>the movement lasted less than a second</source>
        <translation>die Bewegung dauerte weniger als eine Sekunde</translation>
    </message>
    <message>
        <source>the name of a database may not hold a quotation mark</source>
        <translation>der Name einer Datenbank darf kein Anführungszeichen enthalten</translation>
    </message>
    <message>
        <source>the network</source>
        <translation>dem Netzwerk</translation>
    </message>
    <message>
        <source>the new backup is made, but this old one cannot be removed</source>
        <translation>die neue Sicherung ist gemacht, aber diese alte lässt sich nicht entfernen</translation>
    </message>
    <message>
        <source>the object moved by less than 5 mm and 5 degrees</source>
        <translation>das Objekt hat sich um weniger als 5 mm und 5 Grad bewegt</translation>
    </message>
    <message>
        <source>the object turned about more than one axis</source>
        <translation>das Objekt hat sich um mehr als eine Achse gedreht</translation>
    </message>
    <message>
        <source>the parameter is given twice</source>
        <translation>der Parameter ist zweimal angegeben</translation>
    </message>
    <message>
        <source>the points of %1 were not loaded</source>
        <translation>die Punkte von %1 wurden nicht geladen</translation>
    </message>
    <message>
        <source>the protocol is missing</source>
        <translation>das Protokoll fehlt</translation>
    </message>
    <message>
        <source>the records of %1 are not released for research</source>
        <translation>die Aufzeichnungen von %1 sind nicht für die Forschung freigegeben</translation>
    </message>
    <message>
        <source>the records of %1 are restricted until %2</source>
        <translation>die Aufzeichnungen von %1 sind bis %2 beschränkt</translation>
    </message>
    <message>
        <source>the records of %1 are restricted until %2: the person asked for erasure</source>
        <translation>die Aufzeichnungen von %1 sind bis %2 beschränkt: Die Person hat um Löschung gebeten</translation>
    </message>
    <message>
        <source>the role %1 has no PIN</source>
        <translation>die Rolle %1 hat keine PIN</translation>
    </message>
    <message>
        <source>the role %1 may not change records</source>
        <translation>die Rolle %1 darf keine Aufzeichnungen ändern</translation>
    </message>
    <message>
        <source>the role %1 may not do this</source>
        <translation>die Rolle %1 darf das nicht</translation>
    </message>
    <message>
        <source>the role %1 may not see who people are</source>
        <translation>die Rolle %1 darf nicht sehen, wer die Personen sind</translation>
    </message>
    <message>
        <source>the screening allows this hand comfortable force only</source>
        <translation>die Vorab-Fragen erlauben dieser Hand nur angenehme Kraft</translation>
    </message>
    <message>
        <source>the screening allows this hand no effort</source>
        <translation>die Vorab-Fragen erlauben dieser Hand keine Anstrengung</translation>
    </message>
    <message>
        <source>the sensor has no such filter</source>
        <translation>der Sensor hat kein solches Filter</translation>
    </message>
    <message>
        <source>the sensors have no such rate</source>
        <translation>die Sensoren haben keine solche Rate</translation>
    </message>
    <message>
        <source>the sensors have no such speed</source>
        <translation>die Sensoren haben keine solche Geschwindigkeit</translation>
    </message>
    <message>
        <source>the serial port cannot be opened: %1</source>
        <translation>der serielle Anschluss kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>the session does not answer</source>
        <translation>die Sitzung antwortet nicht</translation>
    </message>
    <message>
        <source>the signals are not those that were recorded (content hash)</source>
        <translation>die Signale sind nicht die aufgezeichneten (Inhalts-Hash)</translation>
    </message>
    <message>
        <source>the signals cannot be packed without loss</source>
        <translation>die Signale lassen sich nicht verlustfrei packen</translation>
    </message>
    <message>
        <source>the target is a share of the %1 of &apos;%2&apos; that no earlier step measures</source>
        <translation>das Ziel ist ein Anteil von „%2“ (%1), das kein früherer Schritt misst</translation>
    </message>
    <message>
        <source>the target is a share of the %1 of &apos;%2&apos;, and no trial of this session measured one</source>
        <translation>das Ziel ist ein Anteil von „%2“ (%1), und kein Versuch dieser Sitzung hat das gemessen</translation>
    </message>
    <message>
        <source>the target of %1 has a band of +-%2, which the sensors cannot resolve</source>
        <translation>das Ziel von %1 hat ein Band von +-%2, das die Sensoren nicht auflösen können</translation>
    </message>
    <message>
        <source>the target of %1 is above the ceiling of %2 for this hand</source>
        <translation>das Ziel von %1 liegt über der Obergrenze von %2 für diese Hand</translation>
    </message>
    <message>
        <source>the thumb&apos;s sensor</source>
        <translation>der Sensor des Daumens</translation>
    </message>
    <message>
        <source>the thumb&apos;s sensor (%1)</source>
        <translation>der Sensor des Daumens (%1)</translation>
    </message>
    <message>
        <source>the time cannot be stretched by %1</source>
        <translation>die Zeit lässt sich nicht um %1 strecken</translation>
    </message>
    <message>
        <source>the time is empty</source>
        <translation>die Zeit ist leer</translation>
    </message>
    <message>
        <source>the times of the samples do not increase</source>
        <translation>die Zeiten der Messwerte nehmen nicht zu</translation>
    </message>
    <message>
        <source>the trial has no samples</source>
        <translation>der Versuch hat keine Messwerte</translation>
    </message>
    <message>
        <source>the trial has no signals</source>
        <translation>der Versuch hat keine Signale</translation>
    </message>
    <message>
        <source>therapist</source>
        <translation>Therapeut</translation>
    </message>
    <message>
        <source>there are %1 primary measures already</source>
        <translation>es gibt schon %1 Hauptmessgrößen</translation>
    </message>
    <message>
        <source>there is no %1 &apos;%2&apos;</source>
        <translation>es gibt nicht: %1 „%2“</translation>
    </message>
    <message>
        <source>there is no file of this name</source>
        <translation>es gibt keine Datei dieses Namens</translation>
    </message>
    <message>
        <source>there is no patient &quot;%1&quot; in this database</source>
        <translation>es gibt keinen Patienten „%1“ in dieser Datenbank</translation>
    </message>
    <message>
        <source>there is no patient %1</source>
        <translation>es gibt keinen Patienten %1</translation>
    </message>
    <message>
        <source>there is no patient &apos;%1&apos;</source>
        <translation>es gibt keinen Patienten „%1“</translation>
    </message>
    <message>
        <source>there is no sensor for the %1</source>
        <translation>es gibt keinen Sensor für: %1</translation>
    </message>
    <message>
        <source>there is no session %1</source>
        <translation>es gibt keine Sitzung %1</translation>
    </message>
    <message>
        <source>there is no such CAN interface</source>
        <translation>es gibt keine solche CAN-Schnittstelle</translation>
    </message>
    <message>
        <source>there is no way to this address: %1</source>
        <translation>es gibt keinen Weg zu dieser Adresse: %1</translation>
    </message>
    <message>
        <source>there is nothing to resume: %1</source>
        <translation>es gibt nichts fortzusetzen: %1</translation>
    </message>
    <message>
        <source>this adaptor tells no serial number: nothing could be compared</source>
        <translation>dieser Adapter nennt keine Seriennummer: Es gibt nichts zu vergleichen</translation>
    </message>
    <message>
        <source>this hand has had no session yet</source>
        <translation>diese Hand hatte noch keine Sitzung</translation>
    </message>
    <message>
        <source>this is no XML: %1</source>
        <translation>das ist kein XML: %1</translation>
    </message>
    <message>
        <source>this is no address in numbers with a port</source>
        <translation>das ist keine Adresse in Zahlen mit Port</translation>
    </message>
    <message>
        <source>this is no page of a Net F/T box: it has not one root element</source>
        <translation>das ist keine Seite einer Net-F/T-Box: Sie hat nicht genau ein Wurzelelement</translation>
    </message>
    <message>
        <source>this is no page of a Net F/T box: it is too large</source>
        <translation>das ist keine Seite einer Net-F/T-Box: Sie ist zu groß</translation>
    </message>
    <message>
        <source>this library has none</source>
        <translation>diese Vorlagen haben keine</translation>
    </message>
    <message>
        <source>this program was built without libcomedi</source>
        <translation>dieses Programm wurde ohne libcomedi gebaut</translation>
    </message>
    <message>
        <source>thumb</source>
        <translation>Daumen</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>time does not increase</source>
        <translation>die Zeit nimmt nicht zu</translation>
    </message>
    <message>
        <source>too many wrong passwords</source>
        <translation>zu viele falsche Passwörter</translation>
    </message>
    <message>
        <source>treatment mark</source>
        <translation>Behandlung</translation>
    </message>
    <message>
        <source>trial %1 has not ended or does not exist</source>
        <translation>der Versuch %1 ist nicht beendet oder nicht vorhanden</translation>
    </message>
    <message>
        <source>trial %1 is not being recorded</source>
        <translation>der Versuch %1 wird nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>trial %1 of session %2%3: %4</source>
        <translation>Versuch %1 der Sitzung %2%3: %4</translation>
    </message>
    <message>
        <source>trials were recorded with this version</source>
        <translation>mit dieser Version wurden Versuche aufgezeichnet</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>erneut versuchen</translation>
    </message>
    <message>
        <source>try again; %1 left</source>
        <translation>erneut versuchen; noch %1</translation>
    </message>
    <message>
        <source>turn the platform and choose the configuration for that hand, or choose the %1 hand</source>
        <translation>die Plattform wenden und die Konfiguration für jene Hand wählen, oder die %1 Hand wählen</translation>
    </message>
    <message>
        <source>turns about more than one axis</source>
        <translation>dreht sich um mehr als eine Achse</translation>
    </message>
    <message>
        <source>two free rotations are not a rotation group: what the locked one means would depend on the order of turning</source>
        <translation>zwei freie Drehungen sind keine Drehgruppe: Was die gesperrte bedeutet, hinge von der Reihenfolge ab</translation>
    </message>
    <message>
        <source>two sensors have this address</source>
        <translation>zwei Sensoren haben diese Adresse</translation>
    </message>
    <message>
        <source>two sensors have this serial port</source>
        <translation>zwei Sensoren haben diesen seriellen Anschluss</translation>
    </message>
    <message>
        <source>two sensors share an identifier or address</source>
        <translation>zwei Sensoren teilen sich eine Kennung oder Adresse</translation>
    </message>
    <message>
        <source>underscores may only follow digits</source>
        <translation>Unterstriche dürfen nur auf Ziffern folgen</translation>
    </message>
    <message>
        <source>underscores must be followed by digits</source>
        <translation>auf Unterstriche müssen Ziffern folgen</translation>
    </message>
    <message>
        <source>unexpected control character</source>
        <translation>unerwartetes Steuerzeichen</translation>
    </message>
    <message>
        <source>unknown column of a finger</source>
        <translation>unbekannte Spalte eines Fingers</translation>
    </message>
    <message>
        <source>unknown escape sequence &apos;%1&apos;</source>
        <translation>unbekannte Zeichenfolge „%1“</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>unbekannter Schlüssel</translation>
    </message>
    <message>
        <source>unknown parameter of %1://</source>
        <translation>unbekannter Parameter von %1://</translation>
    </message>
    <message>
        <source>use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>use 10 to 1000</source>
        <translation>10 bis 1000 verwenden</translation>
    </message>
    <message>
        <source>use 10, 20, 50, 100, 200, 333, 500 or 1000</source>
        <translation>10, 20, 50, 100, 200, 333, 500 oder 1000 verwenden</translation>
    </message>
    <message>
        <source>use 57600, 115200, 230400, 460800 or 921600</source>
        <translation>57600, 115200, 230400, 460800 oder 921600 verwenden</translation>
    </message>
    <message>
        <source>use a generated code of letters, digits and &apos;-&apos;, such as P-0427</source>
        <translation>einen erzeugten Code aus Buchstaben, Ziffern und „-“ verwenden, etwa P-0427</translation>
    </message>
    <message>
        <source>use a rate that the box has: a whole fraction of 7000 Hz</source>
        <translation>eine Rate verwenden, die die Box hat: einen ganzen Bruchteil von 7000 Hz</translation>
    </message>
    <message>
        <source>use one of those present: %1</source>
        <translation>eine der vorhandenen verwenden: %1</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>eines davon verwenden: %1</translation>
    </message>
    <message>
        <source>use rft, ati-netcanoem, jr3-can or net-ft</source>
        <translation>rft, ati-netcanoem, jr3-can oder net-ft verwenden</translation>
    </message>
    <message>
        <source>use sim://healthy, replay://FILE.csv, can://, udp://, serial:// or comedi:// (see: isograsp devices)</source>
        <translation>sim://healthy, replay://DATEI.csv, can://, udp://, serial:// oder comedi:// verwenden (siehe: isograsp devices)</translation>
    </message>
    <message>
        <source>use the calibration of this sensor</source>
        <translation>die Kalibrierung dieses Sensors verwenden</translation>
    </message>
    <message>
        <source>use the comfortable-force task, and targets in newtons or of comfortable force</source>
        <translation>die Aufgabe für angenehme Kraft und Ziele in Newton oder als Anteil der angenehmen Kraft verwenden</translation>
    </message>
    <message>
        <source>use the program that made it</source>
        <translation>das Programm verwenden, das sie gemacht hat</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>value or closing &apos;]&apos;</source>
        <translation>Wert oder „]“</translation>
    </message>
    <message>
        <source>value-terminator</source>
        <translation>Ende des Werts</translation>
    </message>
    <message>
        <source>values may not begin with underscores</source>
        <translation>Werte dürfen nicht mit Unterstrichen beginnen</translation>
    </message>
    <message>
        <source>wait %1 s, then try again</source>
        <translation>%1 s warten, dann erneut versuchen</translation>
    </message>
    <message>
        <source>was made by a newer isograsp (format %1, this program knows %2)</source>
        <translation>wurde von einem neueren isograsp gemacht (Format %1, dieses Programm kennt %2)</translation>
    </message>
    <message>
        <source>was made by an older isograsp (format %1, this program writes %2)</source>
        <translation>wurde von einem älteren isograsp gemacht (Format %1, dieses Programm schreibt %2)</translation>
    </message>
    <message>
        <source>whoever opened the database has fewer rights than this account</source>
        <translation>wer die Datenbank geöffnet hat, hat weniger Rechte als dieses Konto</translation>
    </message>
    <message>
        <source>write %1 numbers in brackets</source>
        <translation>%1 Zahlen in Klammern schreiben</translation>
    </message>
    <message>
        <source>write %25 for a percent sign</source>
        <translation>für ein Prozentzeichen %25 schreiben</translation>
    </message>
    <message>
        <source>write &apos;@isograsp - rtprio 50&apos; and &apos;@isograsp - memlock unlimited&apos; to /etc/security/limits.d/isograsp.conf, join that group and log in again (check: ulimit -r, ulimit -l), or use --realtime=prefer</source>
        <translation>„@isograsp - rtprio 50“ und „@isograsp - memlock unlimited“ in /etc/security/limits.d/isograsp.conf schreiben, dieser Gruppe beitreten und sich neu anmelden (prüfen: ulimit -r, ulimit -l), oder --realtime=prefer verwenden</translation>
    </message>
    <message>
        <source>write +x, -x, … -z</source>
        <translation>+x, -x, … -z schreiben</translation>
    </message>
    <message>
        <source>write 0 or more</source>
        <translation>0 oder mehr schreiben</translation>
    </message>
    <message>
        <source>write a direction across the normal</source>
        <translation>eine Richtung quer zur Normalen schreiben</translation>
    </message>
    <message>
        <source>write a larger number</source>
        <translation>eine größere Zahl schreiben</translation>
    </message>
    <message>
        <source>write a later day</source>
        <translation>einen späteren Tag schreiben</translation>
    </message>
    <message>
        <source>write a longer time</source>
        <translation>eine längere Zeit schreiben</translation>
    </message>
    <message>
        <source>write a name, for people</source>
        <translation>einen Namen für Menschen schreiben</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>eine Zahl schreiben</translation>
    </message>
    <message>
        <source>write a number above 0</source>
        <translation>eine Zahl über 0 schreiben</translation>
    </message>
    <message>
        <source>write a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2 schreiben</translation>
    </message>
    <message>
        <source>write a number that is not negative</source>
        <translation>eine Zahl schreiben, die nicht negativ ist</translation>
    </message>
    <message>
        <source>write a number with &apos;.&apos; as the decimal sign, or leave the field empty if the value is missing</source>
        <translation>eine Zahl mit „.“ als Dezimalzeichen schreiben oder das Feld leer lassen, wenn der Wert fehlt</translation>
    </message>
    <message>
        <source>write a recovery or a factor</source>
        <translation>eine Erholung oder einen Faktor schreiben</translation>
    </message>
    <message>
        <source>write a smaller factor</source>
        <translation>einen kleineren Faktor schreiben</translation>
    </message>
    <message>
        <source>write a table</source>
        <translation>eine Tabelle schreiben</translation>
    </message>
    <message>
        <source>write a unit quaternion w, x, y, z</source>
        <translation>eine Einheitsquaternion w, x, y, z schreiben</translation>
    </message>
    <message>
        <source>write a value from %1 to %2</source>
        <translation>einen Wert von %1 bis %2 schreiben</translation>
    </message>
    <message>
        <source>write a whole number</source>
        <translation>eine ganze Zahl schreiben</translation>
    </message>
    <message>
        <source>write a whole number from 0 to 100</source>
        <translation>eine ganze Zahl von 0 bis 100 schreiben</translation>
    </message>
    <message>
        <source>write a whole number from 1 to %1</source>
        <translation>eine ganze Zahl von 1 bis %1 schreiben</translation>
    </message>
    <message>
        <source>write a whole number such as day=14</source>
        <translation>eine ganze Zahl wie day=14 schreiben</translation>
    </message>
    <message>
        <source>write a whole number such as seed=7</source>
        <translation>eine ganze Zahl wie seed=7 schreiben</translation>
    </message>
    <message>
        <source>write an angle such as 1e-9</source>
        <translation>einen Winkel wie 1e-9 schreiben</translation>
    </message>
    <message>
        <source>write another level</source>
        <translation>ein anderes Niveau schreiben</translation>
    </message>
    <message>
        <source>write at most %1</source>
        <translation>höchstens %1 schreiben</translation>
    </message>
    <message>
        <source>write both bounds in one entry</source>
        <translation>beide Enden in einen Eintrag schreiben</translation>
    </message>
    <message>
        <source>write can://can0?protocol=rft</source>
        <translation>can://can0?protocol=rft schreiben</translation>
    </message>
    <message>
        <source>write e.g. [0, 0, 1]</source>
        <translation>z. B. [0, 0, 1] schreiben</translation>
    </message>
    <message>
        <source>write each as [[%1%2]]</source>
        <translation>jede als [[%1%2]] schreiben</translation>
    </message>
    <message>
        <source>write each entry in double quotes</source>
        <translation>jeden Eintrag in doppelte Anführungszeichen setzen</translation>
    </message>
    <message>
        <source>write for example day=0</source>
        <translation>zum Beispiel day=0 schreiben</translation>
    </message>
    <message>
        <source>write frequencies up to 5 Hz</source>
        <translation>Frequenzen bis 5 Hz schreiben</translation>
    </message>
    <message>
        <source>write grip, grip_mean, pinch, sum, thumb, index, middle, opening, index_opening or e.g. thumb_-x</source>
        <translation>grip, grip_mean, pinch, sum, thumb, index, middle, opening, index_opening oder z. B. thumb_-x schreiben</translation>
    </message>
    <message>
        <source>write hand=right or hand=left</source>
        <translation>hand=right oder hand=left schreiben</translation>
    </message>
    <message>
        <source>write how many rows before the end it begins and ends, e.g. [200, 50]</source>
        <translation>schreiben, wie viele Zeilen vor dem Ende es beginnt und endet, z. B. [200, 50]</translation>
    </message>
    <message>
        <source>write how many units one step is</source>
        <translation>schreiben, wie viele Einheiten ein Schritt ist</translation>
    </message>
    <message>
        <source>write it as 192.168.1.1</source>
        <translation>als 192.168.1.1 schreiben</translation>
    </message>
    <message>
        <source>write it as 192.168.1.1:49152</source>
        <translation>als 192.168.1.1:49152 schreiben</translation>
    </message>
    <message>
        <source>write it as [%1%2]</source>
        <translation>als [%1%2] schreiben</translation>
    </message>
    <message>
        <source>write it in double quotes</source>
        <translation>in doppelte Anführungszeichen setzen</translation>
    </message>
    <message>
        <source>write it to a file first and name that</source>
        <translation>schreiben Sie es erst in eine Datei und nennen Sie diese</translation>
    </message>
    <message>
        <source>write its points into [axis.csv_data], or choose another shape</source>
        <translation>die Punkte in [axis.csv_data] schreiben oder eine andere Form wählen</translation>
    </message>
    <message>
        <source>write lines as (1700000000.001000) 192.168.1.1:49152 00000001 with the bytes in hexadecimal</source>
        <translation>Zeilen wie (1700000000.001000) 192.168.1.1:49152 00000001 schreiben, die Bytes hexadezimal</translation>
    </message>
    <message>
        <source>write lines as (1700000000.001000) can0 064#0C00000000000000</source>
        <translation>Zeilen wie (1700000000.001000) can0 064#0C00000000000000 schreiben</translation>
    </message>
    <message>
        <source>write numbers</source>
        <translation>Zahlen schreiben</translation>
    </message>
    <message>
        <source>write numbers up to %1</source>
        <translation>Zahlen bis %1 schreiben</translation>
    </message>
    <message>
        <source>write one [[axis]] per degree of freedom</source>
        <translation>je Freiheitsgrad eine [[axis]] schreiben</translation>
    </message>
    <message>
        <source>write one of: %1</source>
        <translation>eines davon schreiben: %1</translation>
    </message>
    <message>
        <source>write one value per time</source>
        <translation>je Zeit einen Wert schreiben</translation>
    </message>
    <message>
        <source>write rate_Hz = 100, or time_column = &quot;t&quot; and time_unit = &quot;s&quot;</source>
        <translation>rate_Hz = 100 oder time_column = &quot;t&quot; und time_unit = &quot;s&quot; schreiben</translation>
    </message>
    <message>
        <source>write replay://FILE.csv</source>
        <translation>replay://DATEI.csv schreiben</translation>
    </message>
    <message>
        <source>write rows per second, e.g. 120</source>
        <translation>Zeilen pro Sekunde schreiben, z. B. 120</translation>
    </message>
    <message>
        <source>write scheme://target?key=value&amp;key=value</source>
        <translation>scheme://target?key=value&amp;key=value schreiben</translation>
    </message>
    <message>
        <source>write sim://healthy or sim://paretic</source>
        <translation>sim://healthy oder sim://paretic schreiben</translation>
    </message>
    <message>
        <source>write some of: x, y, z, rx, ry, rz</source>
        <translation>einige davon schreiben: x, y, z, rx, ry, rz</translation>
    </message>
    <message>
        <source>write texts in brackets</source>
        <translation>Texte in Klammern schreiben</translation>
    </message>
    <message>
        <source>write the column&apos;s name, with &apos;-&apos; before it to turn the sign</source>
        <translation>den Namen der Spalte schreiben, mit „-“ davor, um das Vorzeichen zu drehen</translation>
    </message>
    <message>
        <source>write the direction into the object</source>
        <translation>die Richtung in das Objekt hinein schreiben</translation>
    </message>
    <message>
        <source>write the file name without folder, e.g. &quot;grip_sine.toml&quot;</source>
        <translation>den Dateinamen ohne Ordner schreiben, z. B. &quot;grip_sine.toml&quot;</translation>
    </message>
    <message>
        <source>write the name of its file without folder and ending, e.g. &quot;planar_block&quot;</source>
        <translation>den Namen ihrer Datei ohne Ordner und Endung schreiben, z. B. &quot;planar_block&quot;</translation>
    </message>
    <message>
        <source>write the secret as text</source>
        <translation>das Geheimnis als Text schreiben</translation>
    </message>
    <message>
        <source>write the secret there</source>
        <translation>das Geheimnis hineinschreiben</translation>
    </message>
    <message>
        <source>write thumb, index or middle</source>
        <translation>thumb, index oder middle schreiben</translation>
    </message>
    <message>
        <source>write thumb, index, middle separated by commas, or give them in the configuration and write %1://?config=FILE</source>
        <translation>thumb, index, middle durch Kommas getrennt schreiben oder in der Konfiguration angeben und %1://?config=DATEI schreiben</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>true oder false schreiben</translation>
    </message>
    <message>
        <source>write version = %1</source>
        <translation>version = %1 schreiben</translation>
    </message>
    <message>
        <source>writing the audit log</source>
        <translation>Zugriffsprotokoll schreiben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the name of another file</source>
        <translation>„%1“ ist der Name einer anderen Datei</translation>
    </message>
    <message>
        <source>No tasks in %1/tasks.</source>
        <translation>Keine Aufgaben in %1/tasks.</translation>
    </message>
    <message>
        <source>control characters other than TAB (U+0009) are explicitly prohibited</source>
        <translation>Steuerzeichen sind nicht erlaubt, nur Tabulatoren</translation>
    </message>
    <message>
        <source>control characters other than TAB (U+0009) are explicitly prohibited in comments</source>
        <translation>Steuerzeichen sind in Kommentaren nicht erlaubt, nur Tabulatoren</translation>
    </message>
    <message>
        <source>there is no %1 number %2</source>
        <translation>es gibt nicht: %1 Nummer %2</translation>
    </message>
    <message>
        <source>unescaped control characters other than TAB (U+0009) are explicitly prohibited</source>
        <translation>Steuerzeichen oder ein Zeilenende im Text; nur Tabulatoren sind erlaubt</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1, memory locked</source>
        <translation>SCHED_FIFO %1, Arbeitsspeicher festgehalten</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1, memory not locked (%2)</source>
        <translation>SCHED_FIFO %1, Arbeitsspeicher nicht festgehalten (%2)</translation>
    </message>
    <message>
        <source>The clock of this computer is behind the newest session of this file (%1).</source>
        <translation>Die Uhr dieses Rechners geht hinter der neuesten Sitzung dieser Datei (%1).</translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>ordinary scheduling (%1), memory locked</source>
        <translation>gewöhnliche Zuteilung (%1), Arbeitsspeicher festgehalten</translation>
    </message>
    <message>
        <source>ordinary scheduling (%1), memory not locked (%2)</source>
        <translation>gewöhnliche Zuteilung (%1), Arbeitsspeicher nicht festgehalten (%2)</translation>
    </message>
    <message>
        <source>set it in the box&apos;s web page, leave filter_Hz out</source>
        <translation>es auf der Webseite der Box einstellen und filter_Hz weglassen</translation>
    </message>
    <message>
        <source>the limit memlock is not unlimited</source>
        <translation>die Grenze memlock ist nicht aufgehoben</translation>
    </message>
    <message>
        <source>this board has none: leave filter_Hz out and use fir_taps</source>
        <translation>diese Platine hat keines: filter_Hz weglassen und fir_taps verwenden</translation>
    </message>
    <message>
        <source>use 0 (none) to 655.35</source>
        <translation>0 (keines) bis 655.35 verwenden</translation>
    </message>
    <message>
        <source>use 0 (none), 500, 125, 31.25, 7.8125, 1.953125 or 0.48828125</source>
        <translation>0 (keines), 500, 125, 31.25, 7.8125, 1.953125 oder 0.48828125 verwenden</translation>
    </message>
    <message>
        <source>use 0 (none), 500, 300, 200, 150, 100, 50, 40, 30, 20, 10, 5, 3, 2 or 1</source>
        <translation>0 (keines), 500, 300, 200, 150, 100, 50, 40, 30, 20, 10, 5, 3, 2 oder 1 verwenden</translation>
    </message>
    <message>
        <source>%1 does not tell its rate</source>
        <translation>%1 nennt seine Rate nicht</translation>
    </message>
    <message>
        <source>%1 sends at %2 Hz, not at %3</source>
        <translation>%1 sendet mit %2 Hz, nicht mit %3</translation>
    </message>
    <message>
        <source>%1 shifts or turns its forces before it sends them</source>
        <translation>%1 verschiebt oder dreht seine Kräfte, bevor er sie sendet</translation>
    </message>
    <message>
        <source>cannot be closed to other programs</source>
        <translation>lässt sich nicht für andere Programme sperren</translation>
    </message>
    <message>
        <source>close it, then do the same again</source>
        <translation>schließen Sie es, dann dasselbe noch einmal</translation>
    </message>
    <message>
        <source>close them, then protect it</source>
        <translation>schließen Sie sie, dann schützen</translation>
    </message>
    <message>
        <source>closing the file to others</source>
        <translation>Sperren der Datei für andere</translation>
    </message>
    <message>
        <source>end that session, then protect it</source>
        <translation>beenden Sie jene Sitzung, dann schützen</translation>
    </message>
    <message>
        <source>give a code that both have</source>
        <translation>geben Sie ein Kürzel an, das beide haben</translation>
    </message>
    <message>
        <source>patient %1 is not in both files</source>
        <translation>Patient %1 steht nicht in beiden Dateien</translation>
    </message>
    <message>
        <source>protect it: isograsp db protect FILE</source>
        <translation>schützen Sie sie: isograsp db protect DATEI</translation>
    </message>
    <message>
        <source>reading an erased code</source>
        <translation>Lesen eines gelöschten Kürzels</translation>
    </message>
    <message>
        <source>reading the last record</source>
        <translation>Lesen der letzten Aufzeichnung</translation>
    </message>
    <message>
        <source>what was removed may still stand in the file and its log: another program reads them</source>
        <translation>Entferntes kann noch in der Datei und ihrem Protokoll stehen: ein anderes Programm liest sie</translation>
    </message>
    <message>
        <source>Grips that were not made</source>
        <translation>Griffe, die ausblieben</translation>
    </message>
    <message>
        <source>no grip was made</source>
        <translation>es wurde nicht gegriffen</translation>
    </message>
    <message>
        <source>no held target appeared outside its tolerance</source>
        <translation>kein gehaltenes Ziel erschien außerhalb seiner Toleranz</translation>
    </message>
    <message>
        <source>no level transport reached its target</source>
        <translation>kein gerader Transport erreichte sein Ziel</translation>
    </message>
    <message>
        <source>no reached target appeared outside its tolerance</source>
        <translation>kein erreichtes Ziel erschien außerhalb seiner Toleranz</translation>
    </message>
    <message>
        <source>no row of a hold counts</source>
        <translation>keine Zeile eines Haltens zählt</translation>
    </message>
    <message>
        <source>no target that asks for a hold was reached</source>
        <translation>kein Ziel, das ein Halten verlangt, wurde erreicht</translation>
    </message>
    <message>
        <source>no target was reached</source>
        <translation>kein Ziel wurde erreicht</translation>
    </message>
    <message>
        <source>the targets ask for no hold</source>
        <translation>die Ziele verlangen kein Halten</translation>
    </message>
    <message>
        <source>the values are too large to compute with</source>
        <translation>die Werte sind zu groß, um damit zu rechnen</translation>
    </message>
    <message>
        <source>the values are too small to compute with</source>
        <translation>die Werte sind zu klein, um damit zu rechnen</translation>
    </message>
    <message>
        <source> was deleted or moved away</source>
        <translation> wurde gelöscht oder verschoben</translation>
    </message>
    <message>
        <source> was replaced</source>
        <translation> wurde ersetzt</translation>
    </message>
    <message>
        <source>%1: %2 while it was open</source>
        <translation>%1: %2, während sie offen war</translation>
    </message>
    <message>
        <source>%1: the file has reached the size that this program may write (RLIMIT_FSIZE), or the disk is full</source>
        <translation>%1: die Datei hat die Größe erreicht, die dieses Programm schreiben darf (RLIMIT_FSIZE), oder der Datenträger ist voll</translation>
    </message>
    <message>
        <source>; all of this session is in %1: isograsp db rescue %2 takes it in</source>
        <translation>; diese Sitzung ist ganz in %1: isograsp db rescue %2 nimmt sie auf</translation>
    </message>
    <message>
        <source>; an emergency file could not be made either: %1</source>
        <translation>; auch eine Notfalldatei konnte nicht angelegt werden: %1</translation>
    </message>
    <message>
        <source>; this was the emergency file</source>
        <translation>; das war die Notfalldatei</translation>
    </message>
    <message>
        <source>check the disk, and restore the last backup</source>
        <translation>Datenträger prüfen und die letzte Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>closing a trial: another program has closed or removed it</source>
        <translation>einen Versuch abschließen: ein anderes Programm hat ihn abgeschlossen oder entfernt</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>er ist nicht da</translation>
    </message>
    <message>
        <source>it is there as &apos;%1&apos; with %2 samples instead of &apos;%3&apos; with %4</source>
        <translation>er ist da als &apos;%1&apos; mit %2 Messwerten statt &apos;%3&apos; mit %4</translation>
    </message>
    <message>
        <source>its measures are not those that were stored</source>
        <translation>seine Maße sind nicht die gespeicherten</translation>
    </message>
    <message>
        <source>its signals are not those that were stored</source>
        <translation>seine Signale sind nicht die gespeicherten</translation>
    </message>
    <message>
        <source>leave the file -lock where it is while a program records</source>
        <translation>die Datei -lock liegen lassen, während ein Programm aufzeichnet</translation>
    </message>
    <message>
        <source>let only one program record into a file</source>
        <translation>nur ein Programm in eine Datei aufzeichnen lassen</translation>
    </message>
    <message>
        <source>making an emergency file</source>
        <translation>eine Notfalldatei anlegen</translation>
    </message>
    <message>
        <source>put it back as it was, or restore the last backup</source>
        <translation>wieder hinlegen, wie sie war, oder die letzte Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>raise that limit (ulimit -f unlimited), or free some space; everything confirmed before is stored</source>
        <translation>diese Grenze anheben (ulimit -f unlimited) oder Platz schaffen; alles vorher Bestätigte ist gespeichert</translation>
    </message>
    <message>
        <source>reading an emergency file</source>
        <translation>eine Notfalldatei lesen</translation>
    </message>
    <message>
        <source>reading back trial %1: %2</source>
        <translation>Versuch %1 zurücklesen: %2</translation>
    </message>
    <message>
        <source>reading who the database is</source>
        <translation>die Kennung der Datenbank lesen</translation>
    </message>
    <message>
        <source>set the clock, or connect again if it is right</source>
        <translation>die Uhr stellen oder erneut verbinden, wenn sie richtig geht</translation>
    </message>
    <message>
        <source>set the clock, or say that it is right</source>
        <translation>die Uhr stellen oder sagen, dass sie richtig geht</translation>
    </message>
    <message>
        <source>the clock of this computer says %1, but the newest session of this file is of %2</source>
        <translation>die Uhr dieses Computers zeigt %1, aber die neueste Sitzung dieser Datei ist von %2</translation>
    </message>
    <message>
        <source>the differences are too large for a number of the computer</source>
        <translation>die Unterschiede sind zu groß für eine Zahl des Computers</translation>
    </message>
    <message>
        <source>the lock (-lock) beside the file was deleted or replaced while it was recorded into: other programs take the running trial for an interrupted one</source>
        <translation>die Sperre (-lock) neben der Datei wurde gelöscht oder ersetzt, während in sie aufgezeichnet wurde: andere Programme halten den laufenden Versuch für abgebrochen</translation>
    </message>
    <message>
        <source>since the zero was set a sensor started anew (%1)</source>
        <translation>seit dem Nullabgleich hat ein Sensor neu gestartet (%1)</translation>
    </message>
    <message>
        <source>take the hand out and set the zero again</source>
        <translation>nehmen Sie die Hand heraus und wiederholen Sie den Nullabgleich</translation>
    </message>
    <message>
        <source>keeping results of a newer version</source>
        <translation>Ergebnisse einer neueren Version aufbewahren</translation>
    </message>
    <message>
        <source>does not hold all of %1 after it was taken in</source>
        <translation>enthält nach der Übernahme nicht alles aus %1</translation>
    </message>
    <message>
        <source>is not there, so nothing can be taken into it</source>
        <translation>ist nicht da, also kann nichts in sie übernommen werden</translation>
    </message>
    <message>
        <source>keep that file, run isograsp db check, and rescue again</source>
        <translation>diese Datei behalten, isograsp db check ausführen und erneut retten</translation>
    </message>
    <message>
        <source>put it back or restore the last backup, then rescue again</source>
        <translation>sie zurücklegen oder die letzte Sicherung wiederherstellen, dann erneut retten</translation>
    </message>
    <message>
        <source>set XDG_STATE_HOME to a folder that you may write to</source>
        <translation>XDG_STATE_HOME auf einen Ordner setzen, in den Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>the copy %1 cannot be put back</source>
        <translation>die Kopie %1 kann nicht zurückgelegt werden</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BackupWork</name>
    <message>
        <source>No backup could be made: %1</source>
        <translation>Es konnte keine Sicherung gemacht werden: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ChannelTable</name>
    <message>
        <source>All channels</source>
        <translation>Alle Kanäle</translation>
    </message>
    <message>
        <source>Fx, N</source>
        <translation>Fx, N</translation>
    </message>
    <message>
        <source>Fy, N</source>
        <translation>Fy, N</translation>
    </message>
    <message>
        <source>Fz, N</source>
        <translation>Fz, N</translation>
    </message>
    <message>
        <source>Tx, mN m</source>
        <translation>Tx, mN m</translation>
    </message>
    <message>
        <source>Ty, mN m</source>
        <translation>Ty, mN m</translation>
    </message>
    <message>
        <source>Tz, mN m</source>
        <translation>Tz, mN m</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Force and moment of each finger in its contact frame: z into the support, after the zero; how much of the friction on the virtual object is used (Tab, then arrow keys)</source>
        <translation>Kraft und Moment jedes Fingers in seinen Kontaktachsen: z in die Auflage hinein, nach dem Nullabgleich; wie viel der Reibung am virtuellen Objekt genutzt wird (Tab, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>slips</source>
        <translation>rutscht</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ComparisonPanel</name>
    <message>
        <source>Compare two sessions</source>
        <translation>Zwei Sitzungen vergleichen</translation>
    </message>
    <message>
        <source>Session A</source>
        <translation>Sitzung A</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>Session B</source>
        <translation>Sitzung B</translation>
    </message>
    <message>
        <source>F5, then Tab</source>
        <translation>F5, dann Tab</translation>
    </message>
    <message>
        <source>All measures</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>Also those for research, not only those of the report (F5, then Tab twice; Space)</source>
        <translation>Auch die für die Forschung, nicht nur die des Berichts (F5, dann zweimal Tab; Leertaste)</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Measures of both sessions</source>
        <translation>Messgrößen beider Sitzungen</translation>
    </message>
    <message>
        <source>Means over the assessments of each session, n of them; up and down arrow keys</source>
        <translation>Mittelwerte über die Assessments jeder Sitzung, n an der Zahl; Pfeiltasten auf und ab</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The two sessions share no assessment.</source>
        <translation>Die beiden Sitzungen haben kein gemeinsames Assessment.</translation>
    </message>
    <message>
        <source>Means over the completed trials without practice and help; n: how many.</source>
        <translation>Mittelwerte über die abgeschlossenen Versuche ohne Übung und Hilfe; n: wie viele.</translation>
    </message>
    <message>
        <source>Not compared: %1.</source>
        <translation>Nicht verglichen: %1.</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ConnectForm</name>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>What is present now, simulated patients, recordings (Alt+4, then arrow keys)</source>
        <translation>Was gerade vorhanden ist, simulierte Patienten, Aufzeichnungen (Alt+4, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Connecting, or saving the session</source>
        <translation>Verbinden oder Speichern der Sitzung</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Finger forces (*.csv);;All files (*)</source>
        <translation>Fingerkräfte (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Cancel connecting</source>
        <translation>Verbinden abbrechen</translation>
    </message>
    <message>
        <source>Do not connect to this device (Alt+C)</source>
        <translation>Nicht mit diesem Gerät verbinden (Alt+C)</translation>
    </message>
    <message>
        <source>Dis&amp;connect</source>
        <translation>&amp;Verbindung trennen</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Verbindung trennen</translation>
    </message>
    <message>
        <source>End the session and disconnect (Alt+C)</source>
        <translation>Sitzung beenden und Verbindung trennen (Alt+V)</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Begin the session: needs patient, hand, screening and device (Alt+C)</source>
        <translation>Sitzung beginnen: braucht Patient, Hand, Vorab-Fragen und Gerät (Alt+V)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::CoursePanel</name>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Choose a session, newest first: up and down arrow keys (F2)</source>
        <translation>Sitzung wählen, neueste zuerst: Pfeiltasten auf und ab (F2)</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Trials of this session</source>
        <translation>Versuche dieser Sitzung</translation>
    </message>
    <message>
        <source>Choose a trial with the arrow keys, open it with Enter or the mouse (F3)</source>
        <translation>Versuch mit den Pfeiltasten wählen, mit Eingabe oder der Maus öffnen (F3)</translation>
    </message>
    <message>
        <source>Trials of session %1</source>
        <translation>Versuche der Sitzung %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::DatedList</name>
    <message>
        <source>%1, by date; the arrow keys choose one, Ctrl+Delete removes it</source>
        <translation>%1, nach Datum; die Pfeiltasten wählen, Strg+Entf entfernt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen entry</source>
        <translation>Den gewählten Eintrag entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen entry; it can be brought back (Ctrl+Delete)</source>
        <translation>Den gewählten Eintrag entfernen; er lässt sich zurückholen (Strg+Entf)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Bring back what was removed last</source>
        <translation>Zuletzt Entferntes zurückholen</translation>
    </message>
    <message>
        <source>Bring back what was removed last (Ctrl+U)</source>
        <translation>Zuletzt Entferntes zurückholen (Strg+U)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::DevicePage</name>
    <message>
        <source>not told</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Guided check</source>
        <translation>Geführte Prüfung</translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation>Ergebnis der Prüfung</translation>
    </message>
    <message>
        <source>One line for every press (Tab, arrow keys)</source>
        <translation>Eine Zeile für jeden Druck (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>What the sensors counted</source>
        <translation>Was die Sensoren gezählt haben</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Samples of each sensor</source>
        <translation>Messwerte jedes Sensors</translation>
    </message>
    <message>
        <source>Counted since the device was connected (Tab, arrow keys)</source>
        <translation>Gezählt, seit das Gerät verbunden ist (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>Faults in this session</source>
        <translation>Störungen in dieser Sitzung</translation>
    </message>
    <message>
        <source>The newest first (Tab, arrow keys)</source>
        <translation>Die neuesten zuerst (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>A device is chosen and connected on the page of the session, once patient and hand are known.</source>
        <translation>Das Gerät wird auf der Seite der Sitzung gewählt und verbunden, sobald Patient und Hand feststehen.</translation>
    </message>
    <message>
        <source>No device is connected.</source>
        <translation>Es ist kein Gerät verbunden.</translation>
    </message>
    <message>
        <source>None so far.</source>
        <translation>Bisher keine.</translation>
    </message>
    <message>
        <source>Stop the chec&amp;k</source>
        <translation>&amp;Prüfung beenden</translation>
    </message>
    <message>
        <source>Chec&amp;k the supports</source>
        <translation>Auflagen &amp;prüfen</translation>
    </message>
    <message>
        <source>You press each empty support as pictured; swapped sensors, wrong signs and turned axes show (Alt+K)</source>
        <translation>Sie drücken jede leere Auflage wie gezeigt; vertauschte Sensoren, falsche Vorzeichen und verdrehte Achsen fallen auf (Alt+P)</translation>
    </message>
    <message>
        <source>Take the hand out, then press each empty support as pictured.</source>
        <translation>Nehmen Sie die Hand heraus und drücken Sie dann jede leere Auflage wie gezeigt.</translation>
    </message>
    <message>
        <source>The check needs a connected device and no running trial.</source>
        <translation>Für die Prüfung muss ein Gerät verbunden sein und darf kein Versuch laufen.</translation>
    </message>
    <message>
        <source>Good samples</source>
        <translation>Gute Messwerte</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Half samples</source>
        <translation>Halbe Messwerte</translation>
    </message>
    <message>
        <source>Meaningless</source>
        <translation>Ohne Bedeutung</translation>
    </message>
    <message>
        <source>Standing still</source>
        <translation>Unverändert</translation>
    </message>
    <message>
        <source>At the end of the range</source>
        <translation>Am Ende des Messbereichs</translation>
    </message>
    <message>
        <source>Overloaded</source>
        <translation>Überlastet</translation>
    </message>
    <message>
        <source>Called wrong by the sensor</source>
        <translation>Vom Sensor als falsch gemeldet</translation>
    </message>
    <message>
        <source>Set up again</source>
        <translation>Neu eingerichtet</translation>
    </message>
    <message>
        <source>%1 samples per second, delay %L2 ms</source>
        <translation>%1 Messwerte pro Sekunde, Verzögerung %L2 ms</translation>
    </message>
    <message>
        <source>%1: serial number %2, up to %3 N, one count is %L4 N</source>
        <translation>%1: Seriennummer %2, bis %3 N, ein Zählschritt ist %L4 N</translation>
    </message>
    <message>
        <source>%L1 min: %2</source>
        <translation>%L1 min: %2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ExportPanel</name>
    <message>
        <source>Exporting …</source>
        <translation>Export läuft …</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>%1 wird exportiert …</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</source>
        <translation>
            <numerusform>%n Versuch geschrieben nach &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</numerusform>
            <numerusform>%n Versuche geschrieben nach &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing was written: %1</source>
        <translation>Es wurde nichts geschrieben: %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>Abgebrochen: Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Research export</source>
        <translation>Forschungsexport</translation>
    </message>
    <message>
        <source>Whose data</source>
        <translation>Wessen Daten</translation>
    </message>
    <message>
        <source>The chosen patient or all (Alt+W, then arrow keys)</source>
        <translation>Der gewählte Patient oder alle (Alt+W, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>The chosen patient</source>
        <translation>Der gewählte Patient</translation>
    </message>
    <message>
        <source>All patients</source>
        <translation>Alle Patienten</translation>
    </message>
    <message>
        <source>F&amp;irst session</source>
        <translation>&amp;Erste Sitzung</translation>
    </message>
    <message>
        <source>L&amp;ast session</source>
        <translation>&amp;Letzte Sitzung</translation>
    </message>
    <message>
        <source>Format of the export</source>
        <translation>Format des Exports</translation>
    </message>
    <message>
        <source>How signals and measures are written (Alt+N, then arrow keys)</source>
        <translation>Wie Signale und Messgrößen geschrieben werden (Alt+Z, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Tables: CSV and JSON</source>
        <translation>Tabellen: CSV und JSON</translation>
    </message>
    <message>
        <source>One file: HDF5</source>
        <translation>Eine Datei: HDF5</translation>
    </message>
    <message>
        <source>Data set: Motion-BIDS</source>
        <translation>Datensatz: Motion-BIDS</translation>
    </message>
    <message>
        <source>Health record: HL7 FHIR</source>
        <translation>Patientenakte: HL7 FHIR</translation>
    </message>
    <message>
        <source>Codes only: no names, dates, notes or addresses of devices are written.</source>
        <translation>Nur Codes: Namen, Datumsangaben, Notizen und Geräteadressen werden nicht geschrieben.</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>E&amp;xport …</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Into a new folder; nothing is overwritten, not during a trial (Alt+E)</source>
        <translation>In einen neuen Ordner; nichts wird überschrieben, nicht während eines Versuchs (Alt+X)</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>Export abbrechen</translation>
    </message>
    <message>
        <source>Nothing of it is kept (Alt+C)</source>
        <translation>Nichts davon bleibt erhalten (Alt+C)</translation>
    </message>
    <message>
        <source>&amp;Whose data</source>
        <translation>&amp;Wessen Daten</translation>
    </message>
    <message>
        <source>Form of the &amp;numbers</source>
        <translation>Form der &amp;Zahlen</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message>
        <source>Files that will be written</source>
        <translation>Dateien, die geschrieben werden</translation>
    </message>
    <message>
        <source>Numbers only (Tab, arrow keys)</source>
        <translation>Nur Zahlen (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>A folder for the export</source>
        <translation>Ein Ordner für den Export</translation>
    </message>
    <message>
        <source>Choose a patient on the start page, or all.</source>
        <translation>Wählen Sie auf der Startseite einen Patienten oder hier alle.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s), below a new folder:</source>
        <translation>
            <numerusform>%n Datei in einem neuen Ordner:</numerusform>
            <numerusform>%n Dateien in einem neuen Ordner:</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is stored yet.</source>
        <translation>Noch ist nichts gespeichert.</translation>
    </message>
    <message>
        <source>Waits for the end of the trial</source>
        <translation>Wartet auf das Ende des Versuchs</translation>
    </message>
    <message numerus="yes">
        <source>%n patient(s) left out: not released for research.</source>
        <translation>
            <numerusform>%n Person ausgelassen: nicht für die Forschung freigegeben.</numerusform>
            <numerusform>%n Personen ausgelassen: nicht für die Forschung freigegeben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::FileInUse</name>
    <message>
        <source>IsoGrasp</source>
        <translation>IsoGrasp</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>ein anderes Programm</translation>
    </message>
    <message>
        <source>This file is open in another window</source>
        <translation>Diese Datei ist in einem anderen Fenster geöffnet</translation>
    </message>
    <message>
        <source>%1&lt;br&gt;is open: %2.&lt;br&gt;&lt;br&gt;Two windows must not change the same records. Look at them here, work in the other window, or open another file.</source>
        <translation>%1&lt;br&gt;ist geöffnet: %2.&lt;br&gt;&lt;br&gt;Zwei Fenster dürfen nicht dieselben Daten ändern. Sehen Sie sie hier an, arbeiten Sie im anderen Fenster, oder öffnen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>&amp;Look only</source>
        <translation>&amp;Nur ansehen</translation>
    </message>
    <message>
        <source>Courses and reports are shown; nothing is changed (Alt+L)</source>
        <translation>Verläufe und Berichte werden gezeigt; nichts wird geändert (Alt+L)</translation>
    </message>
    <message>
        <source>&amp;Open another file …</source>
        <translation>&amp;Andere Datei öffnen …</translation>
    </message>
    <message>
        <source>Choose another database (Alt+O)</source>
        <translation>Eine andere Datenbank wählen (Alt+O)</translation>
    </message>
    <message>
        <source>L&amp;eave</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Open nothing (Alt+E, Escape)</source>
        <translation>Nichts öffnen (Alt+E, Escape)</translation>
    </message>
    <message>
        <source>Open another file</source>
        <translation>Andere Datei öffnen</translation>
    </message>
    <message>
        <source>Databases (*.db);;All files (*)</source>
        <translation>Datenbanken (*.db);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::FingerBar</name>
    <message>
        <source>%1: normal force, pressing is positive</source>
        <translation>%1: Normalkraft, Drücken ist positiv</translation>
    </message>
    <message>
        <source>%1, no force yet</source>
        <translation>%1, noch keine Kraft</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>overload</source>
        <translation>Überlast</translation>
    </message>
    <message>
        <source>at its limit</source>
        <translation>am Anschlag</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HistoryPanel</name>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>Task and measure</source>
        <translation>Aufgabe und Messgröße</translation>
    </message>
    <message>
        <source>Which measure of the patient is shown (Alt+H)</source>
        <translation>Welche Messgröße des Patienten gezeigt wird (Alt+V)</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Stored values</source>
        <translation>Gespeicherte Werte</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>The same values in order; hollow dots are practice trials</source>
        <translation>Dieselben Werte der Reihe nach; hohle Punkte sind Übungsversuche</translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1, Übung</translation>
    </message>
    <message>
        <source>Choose a patient to see what is stored.</source>
        <translation>Wählen Sie einen Patienten, um Gespeichertes zu sehen.</translation>
    </message>
    <message>
        <source>Reading what is stored …</source>
        <translation>Gespeichertes wird gelesen …</translation>
    </message>
    <message>
        <source>Nothing stored for this patient yet.</source>
        <translation>Für diesen Patienten ist noch nichts gespeichert.</translation>
    </message>
    <message>
        <source>Every stored value of this measure (Tab, arrow keys)</source>
        <translation>Jeder gespeicherte Wert dieser Messgröße (Tab, Pfeiltasten)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::IdentityCard</name>
    <message>
        <source>Identity</source>
        <translation>Identität</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Encrypted (Tab)</source>
        <translation>Verschlüsselt (Tab)</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Geboren</translation>
    </message>
    <message>
        <source>Date of birth, encrypted (Tab)</source>
        <translation>Geburtsdatum, verschlüsselt (Tab)</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Show the identit&amp;y</source>
        <translation>Identität &amp;zeigen</translation>
    </message>
    <message>
        <source>Show the identity</source>
        <translation>Identität zeigen</translation>
    </message>
    <message>
        <source>Who this code is; the audit log says who looked (Alt+Y)</source>
        <translation>Wer dieser Code ist; das Protokoll sagt, wer nachgesehen hat (Alt+Y)</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Ablegen</translation>
    </message>
    <message>
        <source>Keep the identity</source>
        <translation>Identität ablegen</translation>
    </message>
    <message>
        <source>Encrypted, apart from everything that was measured (Alt+K)</source>
        <translation>Verschlüsselt, getrennt von allem Gemessenen (Alt+K)</translation>
    </message>
    <message>
        <source>Nothing is known of this person yet.</source>
        <translation>Von dieser Person ist noch nichts bekannt.</translation>
    </message>
    <message>
        <source>Kept.</source>
        <translation>Abgelegt.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LibraryPage</name>
    <message>
        <source>Library</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>&amp;Tasks</source>
        <translation>&amp;Aufgaben</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>What the patient is asked to do (Alt+T)</source>
        <translation>Was der Patient tun soll (Alt+A)</translation>
    </message>
    <message>
        <source>&amp;Scenes</source>
        <translation>&amp;Szenen</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>Objects that a task can have (Alt+S)</source>
        <translation>Objekte, die eine Aufgabe haben kann (Alt+S)</translation>
    </message>
    <message>
        <source>&amp;Protocols</source>
        <translation>&amp;Protokolle</translation>
    </message>
    <message>
        <source>Protocols</source>
        <translation>Protokolle</translation>
    </message>
    <message>
        <source>What sessions consist of (Alt+P)</source>
        <translation>Woraus Sitzungen bestehen (Alt+P)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the library</source>
        <translation>Vorlagen durchsuchen</translation>
    </message>
    <message>
        <source>Any part of the name or of the file (Alt+F)</source>
        <translation>Ein Teil des Namens oder der Datei (Alt+F)</translation>
    </message>
    <message>
        <source>Files of the library</source>
        <translation>Dateien der Vorlagen</translation>
    </message>
    <message>
        <source>Arrow keys choose one, Enter goes to its text (Alt+I)</source>
        <translation>Pfeiltasten wählen eine, Eingabe geht zu ihrem Text (Alt+I)</translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation>&amp;Zurückholen</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>The file that was removed last (Alt+B)</source>
        <translation>Die zuletzt entfernte Datei (Alt+Z)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>An own file with this text under a new name (Alt+D)</source>
        <translation>Eine eigene Datei mit diesem Text unter neuem Namen (Alt+K)</translation>
    </message>
    <message>
        <source>Sa&amp;ve</source>
        <translation>Spei&amp;chern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Sessions use it from now on; what a stored trial used is kept (Ctrl+S)</source>
        <translation>Sitzungen verwenden es ab jetzt; was ein gespeicherter Versuch verwendete, bleibt erhalten (Strg+S)</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>What was saved last; Undo brings your text back (Alt+R)</source>
        <translation>Zum zuletzt Gespeicherten; Rückgängig holt Ihren Text zurück (Alt+V)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Puts this own file away; it can be brought back (Alt+M)</source>
        <translation>Legt diese eigene Datei weg; sie kann zurückgeholt werden (Alt+E)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Rückgängig (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Shift+Z)</source>
        <translation>Wiederholen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>Text der Datei</translation>
    </message>
    <message>
        <source>Ctrl+Z undoes, Ctrl+Shift+Z redoes; Tab leaves the text (Alt+X)</source>
        <translation>Strg+Z macht rückgängig, Strg+Umschalt+Z wiederholt; Tab verlässt den Text (Alt+X)</translation>
    </message>
    <message>
        <source>&amp;Go to line</source>
        <translation>Zur Zei&amp;le</translation>
    </message>
    <message>
        <source>Go to the line of the problem</source>
        <translation>Zur Zeile des Problems gehen</translation>
    </message>
    <message>
        <source>The cursor to the line that the reader refuses (Alt+G)</source>
        <translation>Die Schreibmarke in die Zeile, die nicht gelesen werden kann (Alt+L)</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Shipped, read-only</source>
        <translation>Mitgeliefert, schreibgeschützt</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>nicht verwendbar</translation>
    </message>
    <message>
        <source>has unsaved changes</source>
        <translation>mit nicht gespeicherten Änderungen</translation>
    </message>
    <message>
        <source>Choose a file.</source>
        <translation>Wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>%1 – not saved</source>
        <translation>%1 – nicht gespeichert</translation>
    </message>
    <message>
        <source>Shipped: it stays as it is. Duplicate it to change it.</source>
        <translation>Mitgeliefert: bleibt, wie sie ist. Kopieren Sie sie, um sie zu ändern.</translation>
    </message>
    <message>
        <source>&amp;Bring back: %1</source>
        <translation>&amp;Zurückholen: %1</translation>
    </message>
    <message>
        <source>Your unsaved changes are here again. Revert takes them back.</source>
        <translation>Ihre nicht gespeicherten Änderungen sind wieder da. „Verwerfen“ nimmt sie zurück.</translation>
    </message>
    <message>
        <source>✓ It can be used.</source>
        <translation>✓ Kann verwendet werden.</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, Zeile %1</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>Nicht aufbewahrt: %1</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Not saved: the database is not open, so that nobody knows what trials used.</source>
        <translation>Nicht gespeichert: Die Datenbank ist nicht geöffnet; was Versuche verwendeten, ist daher nicht bekannt.</translation>
    </message>
    <message>
        <source>Saved as version %1: trials were recorded with the former text, which is kept.</source>
        <translation>Als Version %1 gespeichert: Mit dem früheren Text wurden Versuche aufgezeichnet; er bleibt erhalten.</translation>
    </message>
    <message>
        <source>Saved. The former text was used and is kept as %1.</source>
        <translation>Gespeichert. Der frühere Text wurde verwendet und bleibt als %1 erhalten.</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LibraryView</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Of the last text that could be read.</source>
        <translation>Vom letzten lesbaren Text.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Steps of the protocol with their durations</source>
        <translation>Schritte des Protokolls mit ihrer Dauer</translation>
    </message>
    <message>
        <source>What it consists of and how long each step takes, in minutes and seconds (Tab, arrow keys)</source>
        <translation>Woraus es besteht und wie lange jeder Schritt dauert, in Minuten und Sekunden (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>What it is, in words</source>
        <translation>Was es ist, in Worten</translation>
    </message>
    <message>
        <source>Durations, what must be measured before, the plan of an object (Tab, arrow keys)</source>
        <translation>Dauer, was vorher zu messen ist, der Plan eines Objekts (Tab, Pfeiltasten)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LivePanel</name>
    <message>
        <source>Live forces</source>
        <translation>Kräfte jetzt</translation>
    </message>
    <message>
        <source>Grip: the smaller of the thumb and the two fingers together. Push: what the whole hand pushes the platform, in % of the grip; from 20 % on arm or trunk take part</source>
        <translation>Griff: der kleinere Wert von Daumen und beiden Fingern zusammen. Schub: womit die ganze Hand gegen die Plattform drückt, in % des Griffs; ab 20 % sind Arm oder Rumpf beteiligt</translation>
    </message>
    <message>
        <source>Forces of the last 20 seconds</source>
        <translation>Kräfte der letzten 20 Sekunden</translation>
    </message>
    <message>
        <source>Thumb T, index I, middle M, and the target dashed; the values stand above</source>
        <translation>Daumen D, Zeigefinger Z, Mittelfinger M und das Ziel gestrichelt; die Werte stehen darüber</translation>
    </message>
    <message>
        <source>Health of the stream: gaps are bridged for at most 50 ms, then the trial waits.
</source>
        <translation>Zustand des Datenstroms: Lücken werden höchstens 50 ms überbrückt, dann wartet der Versuch.
</translation>
    </message>
    <message>
        <source>%1 %2 N</source>
        <translation>%1 %2 N</translation>
    </message>
    <message>
        <source>%1, no force yet</source>
        <translation>%1, noch keine Kraft</translation>
    </message>
    <message>
        <source>All channels</source>
        <translation>Alle Kanäle</translation>
    </message>
    <message>
        <source>All eighteen forces and moments in numbers (Ctrl+L)</source>
        <translation>Alle achtzehn Kräfte und Momente in Zahlen (Strg+L)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LivePlot</name>
    <message>
        <source>Time before now (s)</source>
        <translation>Zeit vor jetzt (s)</translation>
    </message>
    <message>
        <source>Normal force (N)</source>
        <translation>Normalkraft (N)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LoginPage</name>
    <message>
        <source>Who are you?</source>
        <translation>Wer sind Sie?</translation>
    </message>
    <message>
        <source>Your account (Alt+W, then arrow keys)</source>
        <translation>Ihr Konto (Alt+W, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>&amp;Who are you?</source>
        <translation>&amp;Wer sind Sie?</translation>
    </message>
    <message>
        <source>With the &amp;password instead</source>
        <translation>Stattdessen mit dem &amp;Passwort</translation>
    </message>
    <message>
        <source>With the password instead</source>
        <translation>Stattdessen mit dem Passwort</translation>
    </message>
    <message>
        <source>For somebody without a PIN, or after three wrong ones (Alt+P)</source>
        <translation>Für jemanden ohne PIN oder nach drei falschen (Alt+P)</translation>
    </message>
    <message>
        <source>&amp;Log in</source>
        <translation>An&amp;melden</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Who logs in stands in the record of every act (Enter)</source>
        <translation>Wer sich anmeldet, steht im Protokoll jeder Handlung (Eingabe)</translation>
    </message>
    <message>
        <source>The clinic&apos;s passphrase</source>
        <translation>Die Passphrase der Klinik</translation>
    </message>
    <message>
        <source>The recovery key</source>
        <translation>Der Wiederherstellungsschlüssel</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>This database is protected</source>
        <translation>Diese Datenbank ist geschützt</translation>
    </message>
    <message>
        <source>Nobody has touched anything for a while, or somebody has locked it. A session that is open goes on behind this page.</source>
        <translation>Eine Zeit lang hat niemand etwas berührt, oder jemand hat gesperrt. Eine offene Sitzung läuft hinter dieser Seite weiter.</translation>
    </message>
    <message>
        <source>Names, notes and goals are encrypted. Log in to open it.</source>
        <translation>Namen, Notizen und Ziele sind verschlüsselt. Melden Sie sich an, um sie zu öffnen.</translation>
    </message>
    <message>
        <source>Pa&amp;ssword or phrase</source>
        <translation>Pa&amp;sswort oder Satz</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>Passphrase of the &amp;clinic</source>
        <translation>Passphrase der &amp;Klinik</translation>
    </message>
    <message>
        <source>Recover&amp;y key, as it was printed</source>
        <translation>Wiederherstellungssch&amp;lüssel, wie er gedruckt wurde</translation>
    </message>
    <message>
        <source>%1 (Enter logs in)</source>
        <translation>%1 (Eingabe meldet an)</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Einen Moment …</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ObjectPathView</name>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>Von rechts</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ObjectSketch</name>
    <message numerus="yes">
        <source>The object in the plane of x and y, with %n target(s)</source>
        <translation>
            <numerusform>Das Objekt in der Ebene von x und y, mit %n Ziel</numerusform>
            <numerusform>Das Objekt in der Ebene von x und y, mit %n Zielen</numerusform>
        </translation>
    </message>
    <message>
        <source>x to the right, y up; arrows: fingers and where they press; outlines: targets in their order, dashed: where an object appears</source>
        <translation>x nach rechts, y nach oben; Pfeile: Finger und wohin sie drücken; Umrisse: Ziele in ihrer Reihenfolge, gestrichelt: wo ein Objekt erscheint</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatientForm</name>
    <message>
        <source>Choose or add a p&amp;atient</source>
        <translation>&amp;Patient wählen oder anlegen</translation>
    </message>
    <message>
        <source>Choose or add a patient</source>
        <translation>Patient wählen oder anlegen</translation>
    </message>
    <message>
        <source>Opens the list of patients (Alt+A)</source>
        <translation>Öffnet die Liste der Patienten (Alt+P)</translation>
    </message>
    <message>
        <source>the whole screen</source>
        <translation>den ganzen Bildschirm</translation>
    </message>
    <message>
        <source>the left half</source>
        <translation>die linke Hälfte</translation>
    </message>
    <message>
        <source>the right half</source>
        <translation>die rechte Hälfte</translation>
    </message>
    <message>
        <source>What the patient sees</source>
        <translation>Was der Patient sieht</translation>
    </message>
    <message>
        <source>For somebody with half the field of view: all is shown on that side (Tab, then arrow keys)</source>
        <translation>Bei halbem Gesichtsfeld: Alles wird auf dieser Seite gezeigt (Tab, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Calm: nothing scrolls</source>
        <translation>Ruhig: nichts läuft durch</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>Töne</translation>
    </message>
    <message>
        <source>Force can be heard</source>
        <translation>Kraft ist zu hören</translation>
    </message>
    <message>
        <source>Instructions are spoken</source>
        <translation>Anweisungen werden gesprochen</translation>
    </message>
    <message>
        <source>The target stands still while the mark crosses it, fingers do not approach</source>
        <translation>Das Ziel steht still, während die Marke es überquert; Finger nähern sich nicht</translation>
    </message>
    <message>
        <source>Soft tones for begin, success and targets</source>
        <translation>Leise Töne für Beginn, Erfolg und Ziele</translation>
    </message>
    <message>
        <source>A tone that is higher above the target, lower below it and quiet on it</source>
        <translation>Ein Ton, über dem Ziel höher, darunter tiefer, im Ziel still</translation>
    </message>
    <message>
        <source>By the voice of this computer, in the language of the window</source>
        <translation>Von der Stimme dieses Rechners, in der Sprache des Fensters</translation>
    </message>
    <message>
        <source>Sees</source>
        <translation>Sieht</translation>
    </message>
    <message>
        <source>%1 (Tab, then space)</source>
        <translation>%1 (Tab, dann Leertaste)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatientPage</name>
    <message>
        <source>Progress</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>The main measures over the sessions (F4)</source>
        <translation>Die wichtigsten Messgrößen über die Sitzungen (F4)</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Any two sessions side by side (F5)</source>
        <translation>Zwei beliebige Sitzungen nebeneinander (F5)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>The opened trial: signals and replay (F6)</source>
        <translation>Der geöffnete Versuch: Signale und Wiedergabe (F6)</translation>
    </message>
    <message>
        <source>Choose a trial at the left and open it with Enter.</source>
        <translation>Wählen Sie links einen Versuch und öffnen Sie ihn mit Eingabe.</translation>
    </message>
    <message>
        <source>trial %1, %2</source>
        <translation>Versuch %1, %2</translation>
    </message>
    <message>
        <source>This trial cannot be read: %1</source>
        <translation>Dieser Versuch kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>No patient</source>
        <translation>Kein Patient</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>Loading …</source>
        <translation>Wird geladen …</translation>
    </message>
    <message>
        <source>Choose a patient to see what is stored.</source>
        <translation>Wählen Sie einen Patienten, um Gespeichertes zu sehen.</translation>
    </message>
    <message>
        <source>The database is not open yet.</source>
        <translation>Die Datenbank ist noch nicht geöffnet.</translation>
    </message>
    <message>
        <source>Nothing stored for this patient yet.</source>
        <translation>Für diesen Patienten ist noch nichts gespeichert.</translation>
    </message>
    <message>
        <source>%1, %2, from %3 to %4</source>
        <translation>%1, %2, vom %3 bis %4</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatientWindow</name>
    <message>
        <source>IsoGrasp: patient screen</source>
        <translation>IsoGrasp: Patientenbildschirm</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PersonCard</name>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Affected side: left</source>
        <translation>Betroffene Seite: links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Affected side: right</source>
        <translation>Betroffene Seite: rechts</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Affected sides: both</source>
        <translation>Betroffene Seiten: beide</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Affected side: none, healthy</source>
        <translation>Betroffene Seite: keine, gesund</translation>
    </message>
    <message>
        <source>Dominant hand: left</source>
        <translation>Dominante Hand: links</translation>
    </message>
    <message>
        <source>Dominant hand: right</source>
        <translation>Dominante Hand: rechts</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Day of the onset</source>
        <translation>Tag des Krankheitsbeginns</translation>
    </message>
    <message>
        <source>Year-month-day; empty: not known; Up and Down change it (Ctrl+Shift+O)</source>
        <translation>Tag.Monat.Jahr; leer: nicht bekannt; Pfeil auf und ab ändern es (Strg+Umschalt+O)</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>What the patient wants to do again; stays in the clinic, never in a research export; Ctrl+Z takes back what was typed (Ctrl+Shift+G)</source>
        <translation>Was der Patient wieder tun möchte; bleibt in der Klinik, nie in einem Forschungsexport; Strg+Z nimmt Getipptes zurück (Strg+Umschalt+G)</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>What colleagues should know; stays in the clinic, never in a research export; Ctrl+Z takes back what was typed (Ctrl+Shift+N)</source>
        <translation>Was Kollegen wissen sollten; bleibt in der Klinik, nie in einem Forschungsexport; Strg+Z nimmt Getipptes zurück (Strg+Umschalt+N)</translation>
    </message>
    <message>
        <source>Affected side</source>
        <translation>Betroffene Seite</translation>
    </message>
    <message>
        <source>Dominant hand</source>
        <translation>Dominante Hand</translation>
    </message>
    <message>
        <source>Onset</source>
        <translation>Krankheitsbeginn</translation>
    </message>
    <message>
        <source>Not stored. %1</source>
        <translation>Nicht gespeichert. %1</translation>
    </message>
    <message>
        <source>Female</source>
        <translation>Weiblich</translation>
    </message>
    <message>
        <source>Sex: female</source>
        <translation>Geschlecht: weiblich</translation>
    </message>
    <message>
        <source>Male</source>
        <translation>Männlich</translation>
    </message>
    <message>
        <source>Sex: male</source>
        <translation>Geschlecht: männlich</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Divers</translation>
    </message>
    <message>
        <source>Sex: other</source>
        <translation>Geschlecht: divers</translation>
    </message>
    <message>
        <source>Year of birth</source>
        <translation>Geburtsjahr</translation>
    </message>
    <message>
        <source>Four digits; empty: not known; the day belongs to the name (Ctrl+Shift+B)</source>
        <translation>Vier Ziffern; leer: nicht bekannt; der Tag gehört zum Namen (Strg+Umschalt+B)</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Saved, but for the onset</source>
        <translation>Gespeichert, bis auf den Krankheitsbeginn</translation>
    </message>
    <message>
        <source>Saved, but for the year of birth</source>
        <translation>Gespeichert, bis auf das Geburtsjahr</translation>
    </message>
    <message>
        <source>Not stored. Give a year from %1 to %2.</source>
        <translation>Nicht gespeichert. Geben Sie ein Jahr von %1 bis %2 an.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PreparePanel</name>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Hand today</source>
        <translation>Hand heute</translation>
    </message>
    <message>
        <source>Screening</source>
        <translation>Vorab-Fragen</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Zero, empty</source>
        <translation>Null, leer</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>Hand im Gerät</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>%1: asked in every session (%2)</source>
        <translation>%1: wird in jeder Sitzung gefragt (%2)</translation>
    </message>
    <message>
        <source>&amp;Left hand</source>
        <translation>&amp;Linke Hand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Alt+L</source>
        <translation>Alt+L</translation>
    </message>
    <message>
        <source>&amp;Right hand</source>
        <translation>&amp;Rechte Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Alt+R</source>
        <translation>Alt+R</translation>
    </message>
    <message>
        <source>Yes, the less affected hand</source>
        <translation>Ja, die weniger betroffene Hand</translation>
    </message>
    <message>
        <source>Yes, today the less affected hand</source>
        <translation>Ja, heute die weniger betroffene Hand</translation>
    </message>
    <message>
        <source>The hand on the affected side is another one; this one is meant (Tab, then space)</source>
        <translation>Die Hand der betroffenen Seite ist eine andere; diese ist gemeint (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>set</source>
        <translation>erfolgt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>one by one</source>
        <translation>einzeln</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>once more</source>
        <translation>noch einmal</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PrimaryCard</name>
    <message>
        <source>Primary measures</source>
        <translation>Hauptmessgrößen</translation>
    </message>
    <message>
        <source>Measure that gets a verdict of change</source>
        <translation>Messgröße, deren Änderung beurteilt wird</translation>
    </message>
    <message>
        <source>Measure that gets a verdict of change; Alt+Down shows all (Ctrl+Shift+M)</source>
        <translation>Messgröße, deren Änderung beurteilt wird; Alt+Pfeil ab zeigt alle (Strg+Umschalt+M)</translation>
    </message>
    <message>
        <source>Who chooses the measure</source>
        <translation>Wer die Messgröße wählt</translation>
    </message>
    <message>
        <source>Make this a primary measure</source>
        <translation>Zur Hauptmessgröße machen</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>No measure is chosen: no change is judged. Choose up to four before the second assessment.</source>
        <translation>Keine Messgröße ist gewählt: Keine Änderung wird beurteilt. Wählen Sie bis zu vier vor dem zweiten Assessment.</translation>
    </message>
    <message>
        <source>New primary measure</source>
        <translation>Neue Hauptmessgröße</translation>
    </message>
    <message>
        <source>Four are chosen. Remove one to choose another.</source>
        <translation>Vier sind gewählt. Entfernen Sie eine, um eine andere zu wählen.</translation>
    </message>
    <message>
        <source>Measures can be chosen from the first assessment on.</source>
        <translation>Messgrößen können ab dem ersten Assessment gewählt werden.</translation>
    </message>
    <message>
        <source>Not added. This measure is chosen already.</source>
        <translation>Nicht hinzugefügt. Diese Messgröße ist schon gewählt.</translation>
    </message>
    <message>
        <source>Not added. Say who chooses it.</source>
        <translation>Nicht hinzugefügt. Geben Sie an, wer sie wählt.</translation>
    </message>
    <message>
        <source>Chosen by</source>
        <translation>Gewählt von</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ProfilePanel</name>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Try to store or read it again</source>
        <translation>Noch einmal speichern oder lesen</translation>
    </message>
    <message>
        <source>Try to store or read it again (Ctrl+Shift+R)</source>
        <translation>Noch einmal speichern oder lesen (Strg+Umschalt+R)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Choose a patient first.</source>
        <translation>Wählen Sie zuerst einen Patienten.</translation>
    </message>
    <message>
        <source>⚠ Not saved: %1</source>
        <translation>⚠ Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>⚠ Not read: %1</source>
        <translation>⚠ Nicht gelesen: %1</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ProtocolForm</name>
    <message>
        <source>%1, practice (%2)</source>
        <translation>%1, Übung (%2)</translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1, Übung</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>About %1 min, at most %2 min, rests included</source>
        <translation>Etwa %1 min, höchstens %2 min, mit Pausen</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>What this session consists of; chosen before connecting (Alt+7, then arrow keys)</source>
        <translation>Woraus diese Sitzung besteht; vor dem Verbinden gewählt (Alt+7, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Tasks one by one</source>
        <translation>Einzelne Aufgaben</translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation>&amp;Fortsetzen</translation>
    </message>
    <message>
        <source>Go on with the interrupted protocol</source>
        <translation>Das unterbrochene Protokoll fortsetzen</translation>
    </message>
    <message>
        <source>What was done is not asked again; zero and resting force are (Alt+G)</source>
        <translation>Erledigtes wird nicht wieder verlangt; Nullabgleich und Ruhekraft schon (Alt+F)</translation>
    </message>
    <message>
        <source>&amp;Begin anew</source>
        <translation>Neu &amp;beginnen</translation>
    </message>
    <message>
        <source>Begin the protocol anew</source>
        <translation>Das Protokoll neu beginnen</translation>
    </message>
    <message>
        <source>Everything is asked again (Alt+B)</source>
        <translation>Alles wird wieder verlangt (Alt+B)</translation>
    </message>
    <message>
        <source>Steps of the protocol</source>
        <translation>Schritte des Protokolls</translation>
    </message>
    <message>
        <source>What is done and what comes (Tab, arrow keys)</source>
        <translation>Was erledigt ist und was kommt (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>You choose every task yourself.</source>
        <translation>Sie wählen jede Aufgabe selbst.</translation>
    </message>
    <message numerus="yes">
        <source>Interrupted today after %n step(s). Go on where it stopped?</source>
        <translation>
            <numerusform>Heute nach %n Schritt unterbrochen. Dort fortsetzen?</numerusform>
            <numerusform>Heute nach %n Schritten unterbrochen. Dort fortsetzen?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::RatingPanel</name>
    <message>
        <source>Kept: effort %1, pain %2. Another number corrects it.</source>
        <translation>Behalten: Anstrengung %1, Schmerz %2. Eine andere Zahl berichtigt.</translation>
    </message>
    <message>
        <source>The other number is missing: nothing is kept yet.</source>
        <translation>Die andere Zahl fehlt: noch ist nichts behalten.</translation>
    </message>
    <message>
        <source>Correct: effort %1, pain %2</source>
        <translation>Ändern: Anstrengung %1, Schmerz %2</translation>
    </message>
    <message>
        <source>Shows the last answer again; another number corrects it, and what it was is kept (Tab, then space)</source>
        <translation>Zeigt die letzte Antwort wieder; eine andere Zahl berichtigt sie, und was sie war, bleibt erhalten (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>The patient says</source>
        <translation>Der Patient sagt</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Anstrengung</translation>
    </message>
    <message>
        <source>Pain</source>
        <translation>Schmerz</translation>
    </message>
    <message>
        <source>0: none, 10: the most. Asked after every block.</source>
        <translation>0: keine, 10: die größte. Wird nach jedem Block gefragt.</translation>
    </message>
    <message>
        <source>Effort</source>
        <comment>beside its numbers</comment>
        <translation>Mühe</translation>
    </message>
    <message>
        <source>Pain</source>
        <comment>beside its numbers</comment>
        <translation>Schmerz</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::Remark</name>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ReportPanel</name>
    <message>
        <source>Progress report</source>
        <translation>Verlaufsbericht</translation>
    </message>
    <message>
        <source>&amp;From session</source>
        <translation>&amp;Ab Sitzung</translation>
    </message>
    <message>
        <source>&amp;To session</source>
        <translation>&amp;Bis Sitzung</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What is written (Alt+O, then arrow keys)</source>
        <translation>Was geschrieben wird (Alt+F, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Web page (HTML)</source>
        <translation>Webseite (HTML)</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>The web page has the same plots and numbers, with a table beside every plot.</source>
        <translation>Die Webseite hat dieselben Diagramme und Zahlen, mit einer Tabelle neben jedem Diagramm.</translation>
    </message>
    <message>
        <source>&amp;Save as …</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Write the patient&apos;s progress report (Ctrl+R, Alt+S)</source>
        <translation>Den Verlaufsbericht des Patienten schreiben (Strg+R, Alt+S)</translation>
    </message>
    <message>
        <source>&amp;Print …</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Print the report</source>
        <translation>Bericht drucken</translation>
    </message>
    <message>
        <source>The pages that are shown, on paper; not during a trial (Alt+P)</source>
        <translation>Die gezeigten Seiten auf Papier; nicht während eines Versuchs (Alt+D)</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>Fortschritt des Berichts</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the report</source>
        <translation>Bericht abbrechen</translation>
    </message>
    <message>
        <source>Write no report; a file that was there stays as it is (Escape)</source>
        <translation>Keinen Bericht schreiben; eine vorhandene Datei bleibt, wie sie ist (Esc)</translation>
    </message>
    <message>
        <source>S&amp;maller</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Smaller pages (Alt+M, Ctrl and the wheel)</source>
        <translation>Kleinere Seiten (Alt+K, Strg und Mausrad)</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>&amp;Größer</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Larger pages (Alt+L, Ctrl and the wheel)</source>
        <translation>Größere Seiten (Alt+G, Strg und Mausrad)</translation>
    </message>
    <message>
        <source>Fit wi&amp;dth</source>
        <translation>Seitenb&amp;reite</translation>
    </message>
    <message>
        <source>Fit width</source>
        <translation>Seitenbreite</translation>
    </message>
    <message>
        <source>A page as wide as the view (Alt+D)</source>
        <translation>Eine Seite so breit wie die Ansicht (Alt+R)</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Vorschau des Berichts</translation>
    </message>
    <message>
        <source>The pages that will be written (arrow keys, Page Up, Page Down, Home, End)</source>
        <translation>Die Seiten, die geschrieben werden (Pfeiltasten, Bild auf, Bild ab, Pos1, Ende)</translation>
    </message>
    <message>
        <source>Report written: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</source>
        <translation>Bericht geschrieben: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</translation>
    </message>
    <message>
        <source>No report was written: %1</source>
        <translation>Es wurde kein Bericht geschrieben: %1</translation>
    </message>
    <message>
        <source>Cancelled: no report was written.</source>
        <translation>Abgebrochen: Es wurde kein Bericht geschrieben.</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>Portable document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Printing page %1 of %2 …</source>
        <translation>Seite %1 von %2 wird gedruckt …</translation>
    </message>
    <message>
        <source>The report was sent to the printer.</source>
        <translation>Der Bericht wurde an den Drucker gesendet.</translation>
    </message>
    <message>
        <source>No patient is chosen.</source>
        <translation>Kein Patient gewählt.</translation>
    </message>
    <message>
        <source>Report of %1: waits for the end of the trial</source>
        <translation>Bericht zu %1: wartet auf das Ende des Versuchs</translation>
    </message>
    <message>
        <source>Report of %1: %2</source>
        <translation>Bericht zu %1: %2</translation>
    </message>
    <message>
        <source>Page %1 of %2, %3 %</source>
        <translation>Seite %1 von %2, %3 %</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Choose a patient on the start page to see the report.</source>
        <translation>Wählen Sie auf der Startseite einen Patienten, um den Bericht zu sehen.</translation>
    </message>
    <message>
        <source>Reading what is stored …</source>
        <translation>Gespeichertes wird gelesen …</translation>
    </message>
    <message>
        <source>Nothing can be shown.</source>
        <translation>Es kann nichts gezeigt werden.</translation>
    </message>
    <message>
        <source>The printer takes nothing: is it connected, has it paper?</source>
        <translation>Der Drucker nimmt nichts an: Ist er angeschlossen, hat er Papier?</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ReportWork</name>
    <message>
        <source>reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>saving</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ReportsPage</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Report, export or values</source>
        <translation>Bericht, Export oder Werte</translation>
    </message>
    <message>
        <source>What is written for people, for research, or looked at (Tab, arrow keys)</source>
        <translation>Was für Menschen oder die Forschung geschrieben oder angesehen wird (Tab, Pfeiltasten)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::RunPanel</name>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Prot&amp;ocol</source>
        <translation>Proto&amp;koll</translation>
    </message>
    <message>
        <source>Follow the protocol</source>
        <translation>Dem Protokoll folgen</translation>
    </message>
    <message>
        <source>The protocol says what comes (Alt+O)</source>
        <translation>Das Protokoll sagt, was kommt (Alt+K)</translation>
    </message>
    <message>
        <source>One &amp;task</source>
        <translation>Eine &amp;Aufgabe</translation>
    </message>
    <message>
        <source>Choose one task</source>
        <translation>Eine Aufgabe wählen</translation>
    </message>
    <message>
        <source>Choose a task yourself; the protocol waits meanwhile (Alt+T)</source>
        <translation>Selbst eine Aufgabe wählen; das Protokoll wartet solange (Alt+A)</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Choose what the patient will do (Alt+T, then arrow keys)</source>
        <translation>Wählen, was der Patient tun wird (Alt+A, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Practice, not an assess&amp;ment</source>
        <translation>Übung, kein Assess&amp;ment</translation>
    </message>
    <message>
        <source>Practice trial</source>
        <translation>Übungsversuch</translation>
    </message>
    <message>
        <source>A practice trial is recorded but counts for no assessment (Alt+M)</source>
        <translation>Ein Übungsversuch wird aufgezeichnet, zählt aber für kein Assessment (Alt+M)</translation>
    </message>
    <message>
        <source>Goes on by itsel&amp;f</source>
        <translation>Läuft von selbst &amp;weiter</translation>
    </message>
    <message>
        <source>The protocol goes on by itself</source>
        <translation>Das Protokoll läuft von selbst weiter</translation>
    </message>
    <message>
        <source>After a rest the next trial begins without a press; F9 holds it (Alt+F)</source>
        <translation>Nach einer Ruhe beginnt der nächste Versuch ohne Tastendruck; F9 hält ihn an (Alt+W)</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stop the trial</source>
        <translation>Den Versuch stoppen</translation>
    </message>
    <message>
        <source>End the trial now; it is kept and marked (F10)</source>
        <translation>Den Versuch jetzt beenden; er wird behalten und gekennzeichnet (F10)</translation>
    </message>
    <message>
        <source>Progress of the trial</source>
        <translation>Fortschritt des Versuchs</translation>
    </message>
    <message>
        <source>How much of the trial is over</source>
        <translation>Wie viel vom Versuch vorbei ist</translation>
    </message>
    <message>
        <source>Easier</source>
        <translation>Leichter</translation>
    </message>
    <message>
        <source>Make the task easier</source>
        <translation>Die Aufgabe leichter machen</translation>
    </message>
    <message>
        <source>The next trial is one step easier (Ctrl+Minus)</source>
        <translation>Der nächste Versuch ist eine Stufe leichter (Strg+Minus)</translation>
    </message>
    <message>
        <source>Harder</source>
        <translation>Schwerer</translation>
    </message>
    <message>
        <source>Make the task harder</source>
        <translation>Die Aufgabe schwerer machen</translation>
    </message>
    <message>
        <source>The next trial is one step harder (Ctrl+Plus)</source>
        <translation>Der nächste Versuch ist eine Stufe schwerer (Strg+Plus)</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Erneut</translation>
    </message>
    <message>
        <source>Repeat the last trial</source>
        <translation>Den letzten Versuch wiederholen</translation>
    </message>
    <message>
        <source>The last trial once more, beside the protocol (Ctrl+Shift+R)</source>
        <translation>Der letzte Versuch noch einmal, neben dem Protokoll (Strg+Umschalt+R)</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Skip the next step of the protocol</source>
        <translation>Den nächsten Schritt des Protokolls auslassen</translation>
    </message>
    <message>
        <source>The next task is not asked for; this is noted (Ctrl+K)</source>
        <translation>Die nächste Aufgabe wird nicht verlangt; das wird vermerkt (Strg+K)</translation>
    </message>
    <message>
        <source>&amp;Helped</source>
        <translation>Ge&amp;holfen</translation>
    </message>
    <message>
        <source>The therapist helps or helped in this trial</source>
        <translation>Der Therapeut hilft oder half bei diesem Versuch</translation>
    </message>
    <message>
        <source>Such a trial is kept but counts for no assessment (Alt+H)</source>
        <translation>Ein solcher Versuch wird behalten, zählt aber für kein Assessment (Alt+H)</translation>
    </message>
    <message>
        <source>Note, then Enter</source>
        <translation>Notiz, dann Eingabe</translation>
    </message>
    <message>
        <source>Note at this moment</source>
        <translation>Notiz zu diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>A remark at this moment, kept with the session (Ctrl+N); Ctrl+M: a mark only</source>
        <translation>Eine Bemerkung zu diesem Zeitpunkt, bleibt bei der Sitzung (Strg+N); Strg+M: nur eine Marke</translation>
    </message>
    <message>
        <source>Stop sho&amp;wing</source>
        <translation>V&amp;orführung beenden</translation>
    </message>
    <message>
        <source>Show the patient ho&amp;w</source>
        <translation>Dem Patienten v&amp;orführen</translation>
    </message>
    <message>
        <source>The patient&apos;s screen shows how a healthy hand does this task (F7, Alt+W)</source>
        <translation>Der Patientenbildschirm zeigt, wie eine gesunde Hand diese Aufgabe macht (F7, Alt+O)</translation>
    </message>
    <message>
        <source>Start: %1</source>
        <translation>Start: %1</translation>
    </message>
    <message>
        <source>Begin (F8, Alt+S)</source>
        <translation>Beginnen (F8, Alt+S)</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>Weiterma&amp;chen</translation>
    </message>
    <message>
        <source>Hold: do not start</source>
        <translation>Anhalten: nicht starten</translation>
    </message>
    <message>
        <source>Paus&amp;e</source>
        <translation>Pa&amp;use</translation>
    </message>
    <message>
        <source>Resume the trial</source>
        <translation>Den Versuch fortsetzen</translation>
    </message>
    <message>
        <source>Hold: nothing begins by itself</source>
        <translation>Anhalten: nichts beginnt von selbst</translation>
    </message>
    <message>
        <source>Pause the trial</source>
        <translation>Den Versuch anhalten</translation>
    </message>
    <message>
        <source>The trial stands still until it is resumed; between trials nothing begins (F9)</source>
        <translation>Der Versuch steht still, bis er fortgesetzt wird; zwischen Versuchen beginnt nichts (F9)</translation>
    </message>
    <message>
        <source>Difficulty %1 %</source>
        <translation>Schwierigkeit %1 %</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>Bericht schreiben …</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>The report of this patient, on its page (Ctrl+R)</source>
        <translation>Der Bericht über diesen Patienten, auf seiner Seite (Strg+R)</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Verbindung trennen</translation>
    </message>
    <message>
        <source>Disconnect: end the session</source>
        <translation>Trennen: die Sitzung beenden</translation>
    </message>
    <message>
        <source>End the session and disconnect (Tab, then Enter)</source>
        <translation>Sitzung beenden und trennen (Tab, dann Eingabe)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScoreCard</name>
    <message>
        <source>Clinical scores</source>
        <translation>Klinische Werte</translation>
    </message>
    <message>
        <source>Day of the score</source>
        <translation>Tag des Werts</translation>
    </message>
    <message>
        <source>Sensation</source>
        <translation>Sensibilität</translation>
    </message>
    <message>
        <source>Clinical scale</source>
        <translation>Klinische Skala</translation>
    </message>
    <message>
        <source>Clinical scale (Alt+Down shows all)</source>
        <translation>Klinische Skala (Alt+Pfeil ab zeigt alle)</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Remark on the score</source>
        <translation>Bemerkung zum Wert</translation>
    </message>
    <message>
        <source>Muscle, side, remark</source>
        <translation>Muskel, Seite, Bemerkung</translation>
    </message>
    <message>
        <source>Add this score</source>
        <translation>Diesen Wert hinzufügen</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>No score is entered. Any scale that the clinic uses anyway helps to read the trends.</source>
        <translation>Kein Wert ist eingetragen. Jede Skala, die die Klinik ohnehin nutzt, hilft, die Verläufe zu lesen.</translation>
    </message>
    <message>
        <source>New score</source>
        <translation>Neuer Wert</translation>
    </message>
    <message>
        <source>Not added. %1</source>
        <translation>Nicht hinzugefügt. %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScorePanel</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Result of the trial</source>
        <translation>Ergebnis des Versuchs</translation>
    </message>
    <message>
        <source>Measures of the running or the last trial (Alt+U)</source>
        <translation>Messgrößen des laufenden oder des letzten Versuchs (Alt+E)</translation>
    </message>
    <message>
        <source>Res&amp;ult</source>
        <translation>&amp;Ergebnis</translation>
    </message>
    <message>
        <source>So far, renewed every second</source>
        <translation>Bisher, jede Sekunde erneuert</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>, practice</source>
        <translation>, Übung</translation>
    </message>
    <message>
        <source>No trial in this session yet.</source>
        <translation>Noch kein Versuch in dieser Sitzung.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScoreRow</name>
    <message>
        <source>%1: %2 of 10</source>
        <translation>%1: %2 von 10</translation>
    </message>
    <message>
        <source>%1: %2 of 10 (Tab, then arrow keys)</source>
        <translation>%1: %2 von 10 (Tab, dann Pfeiltasten)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScreeningForm</name>
    <message>
        <source>Nothing applies, no &amp;pain</source>
        <translation>Nichts trifft &amp;zu, kein Schmerz</translation>
    </message>
    <message>
        <source>Nothing applies, no pain: maximum allowed</source>
        <translation>Nichts trifft zu, kein Schmerz: Maximum erlaubt</translation>
    </message>
    <message>
        <source>None of the reasons below, no pain: maximal effort is allowed (Alt+P)</source>
        <translation>Keiner der Gründe unten, kein Schmerz: maximale Kraft ist erlaubt (Alt+Z)</translation>
    </message>
    <message>
        <source>%1 (Tab, then space)</source>
        <translation>%1 (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Pain now, at rest</source>
        <translation>Schmerz jetzt, in Ruhe</translation>
    </message>
    <message>
        <source>Pain now</source>
        <translation>Schmerz jetzt</translation>
    </message>
    <message>
        <source>You decide for this hand</source>
        <translation>Sie entscheiden für diese Hand</translation>
    </message>
    <message>
        <source>%1 of this hand today (Tab, then space)</source>
        <translation>%1 für diese Hand heute (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>No target above</source>
        <translation>Kein Ziel über</translation>
    </message>
    <message>
        <source>Limit all targets</source>
        <translation>Alle Ziele begrenzen</translation>
    </message>
    <message>
        <source>No target may exceed this force (Tab, then space)</source>
        <translation>Kein Ziel darf diese Kraft übersteigen (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Largest target in newtons</source>
        <translation>Größtes Ziel in Newton</translation>
    </message>
    <message>
        <source>No target may exceed this force (Tab, arrow keys)</source>
        <translation>Kein Ziel darf diese Kraft übersteigen (Tab, Pfeiltasten)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SegmentedChoice</name>
    <message>
        <source>%1; pressed again: not told (%2)</source>
        <translation>%1; noch einmal gedrückt: nicht angegeben (%2)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SessionFlow</name>
    <message>
        <source>Left out: %1: %2; %3</source>
        <translation>Ausgelassen: %1: %2; %3</translation>
    </message>
    <message>
        <source>The task asks for %1° per newton; the patient&apos;s screen can show %2°, which is stored. Nearer eyes or a larger picture show more.</source>
        <translation>Die Aufgabe verlangt %1° je Newton; der Bildschirm des Patienten kann %2° zeigen, das wird gespeichert. Nähere Augen oder ein größeres Bild zeigen mehr.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SessionSpan</name>
    <message>
        <source>%1 (Alt+%2, then arrow keys)</source>
        <translation>%1 (Alt+%2, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SessionTrendPlot</name>
    <message>
        <source>assessment</source>
        <translation>Assessment</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>helped</source>
        <translation>mit Hilfe</translation>
    </message>
    <message>
        <source>mean of a session&apos;s assessments</source>
        <translation>Mittelwert der Assessments einer Sitzung</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SettingsFile</name>
    <message>
        <source>%1: %2 = &quot;%3&quot; is not a number from %4 to %5; it counts as not set. Correct it in the settings.</source>
        <translation>%1: %2 = &quot;%3&quot; ist keine Zahl von %4 bis %5; es gilt als nicht gesetzt. Berichtigen Sie es in den Einstellungen.</translation>
    </message>
    <message>
        <source>%1 is not a settings file; everything is as at first. Set it anew, or remove the file.</source>
        <translation>%1 ist keine Einstellungsdatei; alles ist wie am Anfang. Stellen Sie es neu ein oder entfernen Sie die Datei.</translation>
    </message>
    <message>
        <source>The settings could not be written to %1: they hold until the program ends.</source>
        <translation>Die Einstellungen konnten nicht nach %1 geschrieben werden: Sie gelten bis zum Ende des Programms.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SettingsPage</name>
    <message>
        <source>This window</source>
        <translation>Dieses Fenster</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of both windows; takes effect at once (Alt+L)</source>
        <translation>Beider Fenster; wirkt sofort (Alt+S)</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Size of letters</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Of this window; the patient&apos;s are always large (Alt+S)</source>
        <translation>Dieses Fensters; die des Patienten ist immer groß (Alt+F)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Size of letters</source>
        <translation>Schri&amp;ftgröße</translation>
    </message>
    <message>
        <source>The hand is no setting: it is asked for in every session.</source>
        <translation>Die Hand ist keine Einstellung: Sie wird in jeder Sitzung gefragt.</translation>
    </message>
    <message>
        <source>The patient&apos;s screen</source>
        <translation>Der Patientenbildschirm</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Where the patient&apos;s screen is shown (Alt+D)</source>
        <translation>Wo der Patientenbildschirm gezeigt wird (Alt+A)</translation>
    </message>
    <message>
        <source>&amp;Display</source>
        <translation>&amp;Anzeige</translation>
    </message>
    <message>
        <source>Distance of the eyes</source>
        <translation>Abstand der Augen</translation>
    </message>
    <message>
        <source>From the patient&apos;s eyes to the screen; with the height of the picture it makes visual angles true (Alt+E)</source>
        <translation>Von den Augen des Patienten zum Bildschirm; mit der Bildhöhe ergibt er richtige Sehwinkel (Alt+G)</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Distance of the &amp;eyes</source>
        <translation>Abstand der Au&amp;gen</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Höhe des Bildes</translation>
    </message>
    <message>
        <source>Measured with a ruler on the patient&apos;s display, edge to edge (Alt+H)</source>
        <translation>Mit dem Lineal auf der Anzeige des Patienten gemessen, von Rand zu Rand (Alt+H)</translation>
    </message>
    <message>
        <source>&amp;Height of the picture</source>
        <translation>&amp;Höhe des Bildes</translation>
    </message>
    <message>
        <source>Delay of the display</source>
        <translation>Verzögerung der Anzeige</translation>
    </message>
    <message>
        <source>From the program to the light, measured with a photodiode or a camera; stored with every session (Alt+Y)</source>
        <translation>Vom Programm bis zum Licht, mit Photodiode oder Kamera gemessen; wird mit jeder Sitzung gespeichert (Alt+V)</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Dela&amp;y of the display</source>
        <translation>&amp;Verzögerung der Anzeige</translation>
    </message>
    <message>
        <source>Which half of the screen a patient sees, less motion, sounds and voice are chosen for each patient, in the first step of a session.</source>
        <translation>Welche Bildschirmhälfte ein Patient sieht, weniger Bewegung, Töne und Stimme werden für jeden Patienten im ersten Schritt einer Sitzung gewählt.</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>Of tones and voice (Alt+U, then arrow keys)</source>
        <translation>Von Tönen und Stimme (Alt+L, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Lo&amp;udness</source>
        <translation>&amp;Lautstärke</translation>
    </message>
    <message>
        <source>Try the sound</source>
        <translation>Ton testen</translation>
    </message>
    <message>
        <source>Plays the tone of success (Alt+T)</source>
        <translation>Spielt den Ton für Erfolg (Alt+T)</translation>
    </message>
    <message>
        <source>&amp;Try the sound</source>
        <translation>&amp;Ton testen</translation>
    </message>
    <message>
        <source>Try the voice</source>
        <translation>Stimme testen</translation>
    </message>
    <message>
        <source>Speaks an instruction (Alt+V)</source>
        <translation>Spricht eine Anweisung (Alt+M)</translation>
    </message>
    <message>
        <source>Try the &amp;voice</source>
        <translation>Stim&amp;me testen</translation>
    </message>
    <message>
        <source>Squeeze with thumb and fingers</source>
        <translation>Mit Daumen und Fingern drücken</translation>
    </message>
    <message>
        <source>The second one, if there is one</source>
        <translation>Die zweite, falls vorhanden</translation>
    </message>
    <message>
        <source>%1 (%2 × %3)</source>
        <translation>%1 (%2 × %3)</translation>
    </message>
    <message>
        <source>%1 (not connected now)</source>
        <translation>%1 (zurzeit nicht verbunden)</translation>
    </message>
    <message>
        <source>as the display tells: %1 cm</source>
        <translation>laut Anzeige: %1 cm</translation>
    </message>
    <message>
        <source>Live forces</source>
        <translation>Kräfte jetzt</translation>
    </message>
    <message>
        <source>How the live grip is shown; newtons are what is stored and reported (Alt+R)</source>
        <translation>Wie der Griff angezeigt wird; gespeichert und berichtet wird in Newton (Alt+K)</translation>
    </message>
    <message>
        <source>in newtons</source>
        <translation>in Newton</translation>
    </message>
    <message>
        <source>in newtons and in % of today&apos;s maximum</source>
        <translation>in Newton und in % des heutigen Maximums</translation>
    </message>
    <message>
        <source>Live fo&amp;rces</source>
        <translation>&amp;Kräfte jetzt</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Who works here; stored with sessions, zeros and resting forces. In a protected database it is whoever logs in (Alt+O)</source>
        <translation>Wer hier arbeitet; gespeichert mit Sitzungen, Nullpunkten und Ruhekräften. In einer geschützten Datenbank ist es, wer sich anmeldet (Alt+B)</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>&amp;Bediener</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StableCard</name>
    <message>
        <source>Judged stable</source>
        <translation>Als stabil beurteilt</translation>
    </message>
    <message>
        <source>First day of the stable time</source>
        <translation>Erster Tag der stabilen Zeit</translation>
    </message>
    <message>
        <source>Last day of the stable time</source>
        <translation>Letzter Tag der stabilen Zeit</translation>
    </message>
    <message>
        <source>Clinician who judges the person stable</source>
        <translation>Fachperson, die die Person als stabil beurteilt</translation>
    </message>
    <message>
        <source>Remark on the stable time</source>
        <translation>Bemerkung zur stabilen Zeit</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Add this stable time</source>
        <translation>Diese stabile Zeit hinzufügen</translation>
    </message>
    <message>
        <source>Times judged stable</source>
        <translation>Als stabil beurteilte Zeiten</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Durch</translation>
    </message>
    <message>
        <source>No stable time is entered. Assessments of people in whom a clinician expects no change tell how large the measurement error of this clinic is.</source>
        <translation>Keine stabile Zeit ist eingetragen. Assessments von Personen, bei denen keine Änderung erwartet wird, zeigen, wie groß der Messfehler dieser Klinik ist.</translation>
    </message>
    <message>
        <source>Stable from, until; judged by whom</source>
        <translation>Stabil von, bis; beurteilt durch</translation>
    </message>
    <message>
        <source>Not added. %1</source>
        <translation>Nicht hinzugefügt. %1</translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation>Der letzte Tag liegt vor dem ersten.</translation>
    </message>
    <message>
        <source>Say which clinician judges so.</source>
        <translation>Geben Sie an, wer so urteilt.</translation>
    </message>
    <message>
        <source>It overlaps the time from %1 until %2.</source>
        <translation>Sie überschneidet sich mit der Zeit von %1 bis %2.</translation>
    </message>
    <message>
        <source>Judged by</source>
        <translation>Beurteilt durch</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StartPage</name>
    <message>
        <source>Patients</source>
        <translation>Patienten</translation>
    </message>
    <message>
        <source>Search a code</source>
        <translation>Code suchen</translation>
    </message>
    <message>
        <source>Search patients</source>
        <translation>Patienten suchen</translation>
    </message>
    <message>
        <source>Type a part of the code (Ctrl+F)</source>
        <translation>Einen Teil des Codes eingeben (Strg+F)</translation>
    </message>
    <message>
        <source>Choose a patient; Enter begins a session (Tab, arrow keys)</source>
        <translation>Patient wählen; Eingabe beginnt eine Sitzung (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>&amp;Add patient</source>
        <translation>Patient &amp;anlegen</translation>
    </message>
    <message>
        <source>Add patient</source>
        <translation>Patient anlegen</translation>
    </message>
    <message>
        <source>Add a patient with a generated code and begin a session (Alt+A)</source>
        <translation>Einen Patienten mit erzeugtem Code anlegen und eine Sitzung beginnen (Alt+A)</translation>
    </message>
    <message>
        <source>&amp;Begin session</source>
        <translation>Sitzung &amp;beginnen</translation>
    </message>
    <message>
        <source>Begin a session</source>
        <translation>Eine Sitzung beginnen</translation>
    </message>
    <message>
        <source>With the chosen patient (Alt+B)</source>
        <translation>Mit dem gewählten Patienten (Alt+B)</translation>
    </message>
    <message>
        <source>Open pat&amp;ient</source>
        <translation>Patient ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Open the patient</source>
        <translation>Den Patienten öffnen</translation>
    </message>
    <message>
        <source>Sessions, measures and trials so far (Alt+I)</source>
        <translation>Bisherige Sitzungen, Messgrößen und Versuche (Alt+F)</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Enter opens the patient (Tab, arrow keys)</source>
        <translation>Eingabe öffnet den Patienten (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>No sessions yet.</source>
        <translation>Noch keine Sitzungen.</translation>
    </message>
    <message>
        <source>This clinic is empty</source>
        <translation>Diese Klinik ist leer</translation>
    </message>
    <message>
        <source>Add the first patient, or look around in a demonstration clinic of simulated patients. It is kept in a file of its own; nothing of it comes into this one.</source>
        <translation>Legen Sie den ersten Patienten an oder sehen Sie sich in einer Demonstrationsklinik mit simulierten Patienten um. Sie liegt in einer eigenen Datei; nichts davon kommt in diese.</translation>
    </message>
    <message>
        <source>Open a demonstration clinic</source>
        <translation>Eine Demonstrationsklinik öffnen</translation>
    </message>
    <message>
        <source>Simulated patients with sessions so far, in a file of their own (Alt+D)</source>
        <translation>Simulierte Patienten mit Sitzungen, in einer eigenen Datei (Alt+D)</translation>
    </message>
    <message>
        <source>Making it …</source>
        <translation>Wird erstellt …</translation>
    </message>
    <message>
        <source>Open a &amp;demonstration clinic</source>
        <translation>&amp;Demonstrationsklinik öffnen</translation>
    </message>
    <message>
        <source>No patients yet. Add the first one.</source>
        <translation>Noch keine Patienten. Legen Sie den ersten an.</translation>
    </message>
    <message>
        <source>No code contains this text.</source>
        <translation>Kein Code enthält diesen Text.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>Tasks one by one</source>
        <translation>Einzelne Aufgaben</translation>
    </message>
    <message>
        <source>%1, simulated</source>
        <translation>%1, simuliert</translation>
    </message>
    <message>
        <source>No session yet; added %1</source>
        <translation>Noch keine Sitzung; angelegt am %1</translation>
    </message>
    <message>
        <source>Last session %1, %2</source>
        <translation>Letzte Sitzung %1, %2</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>TODAY</source>
        <translation>HEUTE</translation>
    </message>
    <message>
        <source>Show &amp;names</source>
        <translation>&amp;Namen zeigen</translation>
    </message>
    <message>
        <source>Show names</source>
        <translation>Namen zeigen</translation>
    </message>
    <message>
        <source>Names beside codes, until the window is locked; the audit log says who read them (Alt+N)</source>
        <translation>Namen neben den Codes, bis das Fenster gesperrt wird; das Protokoll sagt, wer sie gelesen hat (Alt+N)</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StateLight</name>
    <message>
        <source>State: %1</source>
        <translation>Zustand: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StepSection</name>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>next</source>
        <translation>als Nächstes</translation>
    </message>
    <message>
        <source>to come</source>
        <translation>kommt noch</translation>
    </message>
    <message>
        <source>Step %1 of %2, %3: %4</source>
        <translation>Schritt %1 von %2, %3: %4</translation>
    </message>
    <message>
        <source>%1: %2. Opens and closes this step (Alt+%3)</source>
        <translation>%1: %2. Öffnet und schließt diesen Schritt (Alt+%3)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StrapForm</name>
    <message>
        <source>Hand is &amp;in and strapped</source>
        <translation>Hand im Gerät, angegur&amp;tet</translation>
    </message>
    <message>
        <source>After a minute of settling the resting force is measured.</source>
        <translation>Nach einer Minute wird die Ruhekraft gemessen.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Posture an&amp;d straps …</source>
        <translation>Haltung un&amp;d Gurte …</translation>
    </message>
    <message>
        <source>Posture and straps</source>
        <translation>Haltung und Gurte</translation>
    </message>
    <message>
        <source>Say how the patient sits and where the straps are (Alt+D)</source>
        <translation>Angeben, wie der Patient sitzt und wo die Gurte sind (Alt+D)</translation>
    </message>
    <message>
        <source>%1: the marks as written on them (Tab)</source>
        <translation>%1: die Marken, wie sie darauf stehen (Tab)</translation>
    </message>
    <message>
        <source>%1 (Tab, then arrow keys)</source>
        <translation>%1 (Tab, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>As last time: %1.</source>
        <translation>Wie letztes Mal: %1.</translation>
    </message>
    <message>
        <source>Now: %1.</source>
        <translation>Jetzt: %1.</translation>
    </message>
    <message>
        <source>Not as last time: %1.</source>
        <translation>Nicht wie letztes Mal: %1.</translation>
    </message>
    <message>
        <source>Hand &amp;in, strapped, as last time</source>
        <translation>Hand angegur&amp;tet, wie letztes Mal</translation>
    </message>
    <message>
        <source>It is as said above. From now a minute to settle, then the resting force can be measured (Alt+I)</source>
        <translation>Es ist wie oben angegeben. Ab jetzt eine Minute zur Ruhe kommen, dann kann die Ruhekraft gemessen werden (Alt+T)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SupportPicture</name>
    <message>
        <source>The three supports, none to be pressed</source>
        <translation>Die drei Auflagen, keine ist zu drücken</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TargetCurve</name>
    <message>
        <source>%1 over time</source>
        <translation>%1 über der Zeit</translation>
    </message>
    <message>
        <source>What is asked of the patient, from begin to end; dashed: not on the screen</source>
        <translation>Was vom Patienten verlangt wird, von Anfang bis Ende; gestrichelt: nicht auf dem Bildschirm</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TherapistWindow</name>
    <message>
        <source>IsoGrasp</source>
        <translation>IsoGrasp</translation>
    </message>
    <message>
        <source>The state of the session and the sensible next step</source>
        <translation>Der Stand der Sitzung und der sinnvolle nächste Schritt</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>Forces come from software or a file, not from a person at this device</source>
        <translation>Die Kräfte kommen aus Software oder einer Datei, nicht von einer Person an diesem Gerät</translation>
    </message>
    <message>
        <source>Patient screen</source>
        <translation>Patientenbildschirm</translation>
    </message>
    <message>
        <source>Show the patient&apos;s screen: full screen on a second display (F11)</source>
        <translation>Den Patientenbildschirm zeigen: im Vollbild auf einer zweiten Anzeige (F11)</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Course or person</source>
        <translation>Verlauf oder Person</translation>
    </message>
    <message>
        <source>What was measured, or what is known of the person (Tab, arrow keys)</source>
        <translation>Was gemessen wurde oder was über die Person bekannt ist (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>Marked.</source>
        <translation>Markiert.</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>AUFZEICHNUNG</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>Gerät: %1</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Lock (%1)</source>
        <translation>Sperren (%1)</translation>
    </message>
    <message>
        <source>Closes the window&apos;s pages until somebody logs in (F12)</source>
        <translation>Schließt die Seiten des Fensters, bis sich jemand anmeldet (F12)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TreatmentCard</name>
    <message>
        <source>Treatment</source>
        <translation>Behandlung</translation>
    </message>
    <message>
        <source>Day of the treatment</source>
        <translation>Tag der Behandlung</translation>
    </message>
    <message>
        <source>Kind of treatment</source>
        <translation>Art der Behandlung</translation>
    </message>
    <message>
        <source>Kind of treatment (Alt+Down shows all)</source>
        <translation>Art der Behandlung (Alt+Pfeil ab zeigt alle)</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Muscles, dose, what changed</source>
        <translation>Muskeln, Dosis, Änderung</translation>
    </message>
    <message>
        <source>Add this treatment</source>
        <translation>Diese Behandlung hinzufügen</translation>
    </message>
    <message>
        <source>Treatments</source>
        <translation>Behandlungen</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>No treatment is entered. What changed, and when, helps to read the trends.</source>
        <translation>Keine Behandlung ist eingetragen. Was sich wann geändert hat, hilft, die Verläufe zu lesen.</translation>
    </message>
    <message>
        <source>New treatment</source>
        <translation>Neue Behandlung</translation>
    </message>
    <message>
        <source>Not added. %1</source>
        <translation>Nicht hinzugefügt. %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrendGrid</name>
    <message>
        <source>No measure of this patient has been stored yet.</source>
        <translation>Für diesen Patienten ist noch keine Messgröße gespeichert.</translation>
    </message>
    <message>
        <source>All measures</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>Back to all measures (Escape, or F4)</source>
        <translation>Zurück zu allen Messgrößen (Esc oder F4)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. Without a value: %2.</source>
        <translation>%1. Ohne Wert: %2.</translation>
    </message>
    <message>
        <source>%1
The trials differ in their parameters, level or object, so that not only the patient changes from one to the next.</source>
        <translation>%1
Die Versuche unterscheiden sich in Parametern, Stufe oder Objekt: Von einem zum nächsten ändert sich nicht nur der Patient.</translation>
    </message>
    <message>
        <source>Disc: assessment, ring: practice, triangle: helped; the line joins the means of the sessions (Escape goes back)</source>
        <translation>Scheibe: Assessment, Ring: Übung, Dreieck: mit Hilfe; die Linie verbindet die Mittelwerte der Sitzungen (Esc geht zurück)</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrendPlot</name>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrendTile</name>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>
%1</source>
        <translation>
%1</translation>
    </message>
    <message>
        <source>%1
%2
Newest value %3.%4 Arrow keys go to the next picture, Enter or a click shows this one large (F4)</source>
        <translation>%1
%2
Neuester Wert %3.%4 Pfeiltasten gehen zum nächsten Bild, Eingabe oder ein Klick zeigt dieses groß (F4)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrialAbout</name>
    <message>
        <source>About this trial</source>
        <translation>Über diesen Versuch</translation>
    </message>
    <message>
        <source>Measures, events and what is known: arrow keys; Enter on an event goes there</source>
        <translation>Messgrößen, Ereignisse und was bekannt ist: Pfeiltasten; Eingabe auf einem Ereignis springt dorthin</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Messgrößen</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Angaben</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>Other measures</source>
        <translation>Weitere Messgrößen</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrialPlot</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>several units</source>
        <translation>mehrere Einheiten</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrialView</name>
    <message>
        <source>Trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Was gezeichnet wird</translation>
    </message>
    <message>
        <source>What is drawn over time: arrow keys choose (Ctrl+G)</source>
        <translation>Was über der Zeit gezeichnet wird: mit den Pfeiltasten wählen (Strg+G)</translation>
    </message>
    <message>
        <source>Choose a trial at the left and open it with Enter.</source>
        <translation>Wählen Sie links einen Versuch und öffnen Sie ihn mit Eingabe.</translation>
    </message>
    <message>
        <source>Path of the object</source>
        <translation>Weg des Objekts</translation>
    </message>
    <message>
        <source>Path, object and target (dashed); filled dots are fingers that touch</source>
        <translation>Weg, Objekt und Ziel (gestrichelt); gefüllte Punkte sind Finger, die berühren</translation>
    </message>
    <message>
        <source>Drawn flat: this display has no OpenGL for the 3D picture.</source>
        <translation>Flach gezeichnet: Diese Anzeige hat kein OpenGL für das 3D-Bild.</translation>
    </message>
    <message>
        <source>Signals of the trial</source>
        <translation>Signale des Versuchs</translation>
    </message>
    <message>
        <source>Left and right arrow keys step by a sample (with Shift by ten), up and down zoom, Space plays; the mouse moves the cursor, a double click shows all (F6)</source>
        <translation>Pfeiltasten links und rechts gehen um einen Messwert (mit Umschalt um zehn), auf und ab zoomen, Leertaste spielt ab; die Maus bewegt die Marke, ein Doppelklick zeigt alles (F6)</translation>
    </message>
    <message>
        <source>Recorded channels</source>
        <translation>Aufgezeichnete Kanäle</translation>
    </message>
    <message>
        <source>Every recorded channel: arrow keys and Space choose what is drawn</source>
        <translation>Jeder aufgezeichnete Kanal: Pfeiltasten und Leertaste wählen, was gezeichnet wird</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Play or pause the replay (Space)</source>
        <translation>Die Wiedergabe abspielen oder anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Time in the trial</source>
        <translation>Zeit im Versuch</translation>
    </message>
    <message>
        <source>Time in the trial: arrow keys 0.1 s, page keys 1 s, Home and End; Space plays</source>
        <translation>Zeit im Versuch: Pfeiltasten 0,1 s, Bildtasten 1 s, Pos1 und Ende; Leertaste spielt ab</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Geschwindigkeit der Wiedergabe</translation>
    </message>
    <message>
        <source>Speed of the replay (keys + and −)</source>
        <translation>Geschwindigkeit der Wiedergabe (Tasten + und −)</translation>
    </message>
    <message>
        <source>Loading %1 …</source>
        <translation>%1 wird geladen …</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>Versuch %1: %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>The object as the patient saw it, and its path (Space)</source>
        <translation>Das Objekt, wie der Patient es sah, und sein Weg (Leertaste)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>&lt;span style=&quot;color:%1&quot;&gt;%2&lt;/span&gt;&amp;nbsp;%3&amp;nbsp;%4</source>
        <translation>&lt;span style=&quot;color:%1&quot;&gt;%2&lt;/span&gt;&amp;nbsp;%3&amp;nbsp;%4</translation>
    </message>
    <message>
        <source>┅</source>
        <translation>┅</translation>
    </message>
    <message>
        <source>━</source>
        <translation>━</translation>
    </message>
    <message>
        <source>targets reached %1</source>
        <translation>erreichte Ziele %1</translation>
    </message>
    <message>
        <source>%L1 ×</source>
        <translation>%L1 ×</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::WorkProgress</name>
    <message>
        <source>How much of it is written</source>
        <translation>Wie viel davon geschrieben ist</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ZeroForm</name>
    <message>
        <source>Device is empty: set &amp;zero</source>
        <translation>Gerät ist leer: &amp;Nullabgleich</translation>
    </message>
    <message>
        <source>Set the zero of the empty device</source>
        <translation>Nullabgleich des leeren Geräts</translation>
    </message>
    <message>
        <source>With no hand in the device: one quiet second becomes zero (Alt+Z)</source>
        <translation>Ohne Hand im Gerät: Eine ruhige Sekunde wird zu null (Alt+N)</translation>
    </message>
    <message>
        <source>No hand, nothing touches the supports?</source>
        <translation>Keine Hand, nichts berührt die Auflagen?</translation>
    </message>
    <message>
        <source>Yes, empt&amp;y</source>
        <translation>&amp;Ja, leer</translation>
    </message>
    <message>
        <source>Yes, the device is empty</source>
        <translation>Ja, das Gerät ist leer</translation>
    </message>
    <message>
        <source>Set the zero now (Alt+Y)</source>
        <translation>Jetzt Nullabgleich (Alt+J)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>Ne&amp;in</translation>
    </message>
    <message>
        <source>No, not yet</source>
        <translation>Nein, noch nicht</translation>
    </message>
    <message>
        <source>Keep the present zero (Alt+N)</source>
        <translation>Den jetzigen Nullabgleich behalten (Alt+I)</translation>
    </message>
    <message>
        <source>Empty; was serviced: ta&amp;ke it</source>
        <translation>Leer, &amp;gewartet: annehmen</translation>
    </message>
    <message>
        <source>The device was serviced or remounted: accept its new zero</source>
        <translation>Das Gerät wurde gewartet oder umgebaut: neuen Nullabgleich annehmen</translation>
    </message>
    <message>
        <source>The empty device reads something else than at its last zero because it was serviced or remounted; this is stored with the zero (Alt+K)</source>
        <translation>Das leere Gerät zeigt etwas anderes als beim letzten Nullabgleich, weil es gewartet oder umgebaut wurde; das wird mit dem Nullabgleich gespeichert (Alt+G)</translation>
    </message>
    <message>
        <source>Measuring the empty device</source>
        <translation>Das leere Gerät wird gemessen</translation>
    </message>
</context>
</TS>
