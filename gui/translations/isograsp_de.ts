<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Arm</name>
    <message>
        <source>Brace</source>
        <translation>Schiene</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Rumpf</translation>
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
        <source>Back of the hand</source>
        <translation>Handrücken</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Gegenstand</translation>
    </message>
    <message>
        <source>Forearm</source>
        <comment>a link that turns</comment>
        <translation>Unterarm</translation>
    </message>
    <message>
        <source>Wrist</source>
        <translation>Handgelenk</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>seen, one marker astray</source>
        <translation>gesehen, ein Marker daneben</translation>
    </message>
    <message>
        <source>too few markers</source>
        <translation>zu wenige Marker</translation>
    </message>
    <message>
        <source>markers on a line</source>
        <translation>Marker auf einer Geraden</translation>
    </message>
    <message>
        <source>markers do not fit</source>
        <translation>Marker passen nicht</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
</context>
<context>
    <name>ArmScreening</name>
    <message>
        <source>Supination</source>
        <translation>Supination</translation>
    </message>
    <message>
        <source>Pronation</source>
        <translation>Pronation</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>Extension</translation>
    </message>
    <message>
        <source>Flexion</source>
        <translation>Flexion</translation>
    </message>
    <message>
        <source>Radial deviation</source>
        <translation>Radialabduktion</translation>
    </message>
    <message>
        <source>Ulnar deviation</source>
        <translation>Ulnarabduktion</translation>
    </message>
    <message>
        <source>Shoulder pain or subluxation</source>
        <translation>Schulterschmerz oder Subluxation</translation>
    </message>
    <message>
        <source>Contracture</source>
        <translation>Kontraktur</translation>
    </message>
    <message>
        <source>Tape allergy or broken skin</source>
        <translation>Pflasterallergie oder Haut verletzt</translation>
    </message>
    <message>
        <source>Turns the forearm by 10°, unaided</source>
        <translation>Dreht den Unterarm selbst um 10°</translation>
    </message>
    <message>
        <source>Holds the object for 10 s</source>
        <translation>Hält den Gegenstand 10 s lang</translation>
    </message>
    <message>
        <source>The arm is supported, and never pulled into its posture</source>
        <translation>Der Arm wird gestützt und nie in eine Haltung gezogen</translation>
    </message>
    <message>
        <source>Of elbow, forearm, wrist or fingers: measure the passive range and enter it below</source>
        <translation>Von Ellbogen, Unterarm, Handgelenk oder Fingern: passiven Umfang messen und unten eintragen</translation>
    </message>
    <message>
        <source>Where markers are put on: bands instead of tape</source>
        <translation>Wo Marker sitzen: Bänder statt Pflaster</translation>
    </message>
    <message>
        <source>Without it tasks of the arm are not offered</source>
        <translation>Ohne dies werden Aufgaben des Arms nicht angeboten</translation>
    </message>
    <message>
        <source>Tasks of the arm need 10° of the forearm and 10 s of holding: take the isometric tasks of the hand instead.</source>
        <translation>Aufgaben des Arms brauchen 10° des Unterarms und 10 s Halten: stattdessen die isometrischen Aufgaben der Hand nehmen.</translation>
    </message>
    <message>
        <source>Support the arm; stop where the shoulder hurts.</source>
        <translation>Arm stützen; aufhören, wo die Schulter schmerzt.</translation>
    </message>
    <message>
        <source>Enter the passive range: no target goes beyond it.</source>
        <translation>Passiven Umfang eintragen: kein Ziel geht darüber hinaus.</translation>
    </message>
    <message>
        <source>Markers on bands or clothes, no tape on the skin.</source>
        <translation>Marker auf Bänder oder Kleidung, kein Pflaster auf die Haut.</translation>
    </message>
    <message>
        <source>A passive range has no angle in it: correct its numbers.</source>
        <translation>Ein passiver Umfang enthält keinen Winkel: Zahlen berichtigen.</translation>
    </message>
    <message>
        <source>Own range</source>
        <translation>Eigener Umfang</translation>
    </message>
    <message>
        <source>Small range: half of the way</source>
        <translation>Kleiner Umfang: halber Weg</translation>
    </message>
    <message>
        <source>No movement</source>
        <translation>Keine Bewegung</translation>
    </message>
    <message>
        <source>own range</source>
        <translation>eigener Umfang</translation>
    </message>
    <message>
        <source>small range</source>
        <translation>kleiner Umfang</translation>
    </message>
    <message>
        <source>no movement</source>
        <translation>keine Bewegung</translation>
    </message>
    <message>
        <source>%1, pain %2</source>
        <translation>%1, Schmerz %2</translation>
    </message>
    <message>
        <source>Supination / pronation</source>
        <translation>Supination / Pronation</translation>
    </message>
    <message>
        <source>Extension / flexion</source>
        <translation>Extension / Flexion</translation>
    </message>
    <message>
        <source>Radial / ulnar deviation</source>
        <translation>Radial- / Ulnarabduktion</translation>
    </message>
</context>
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
    <name>Consent</name>
    <message>
        <source>Treatment</source>
        <translation>Behandlung</translation>
    </message>
    <message>
        <source>Research</source>
        <comment>purpose</comment>
        <translation>Forschung</translation>
    </message>
    <message>
        <source>Teaching</source>
        <translation>Lehre</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Contract</source>
        <translation>Vertrag</translation>
    </message>
    <message>
        <source>Legal obligation</source>
        <translation>Rechtliche Verpflichtung</translation>
    </message>
    <message>
        <source>Vital interests</source>
        <translation>Lebenswichtige Interessen</translation>
    </message>
    <message>
        <source>Public interest</source>
        <translation>Öffentliches Interesse</translation>
    </message>
    <message>
        <source>Legitimate interest</source>
        <translation>Berechtigtes Interesse</translation>
    </message>
    <message>
        <source>Care</source>
        <translation>Gesundheitsversorgung</translation>
    </message>
    <message>
        <source>Research</source>
        <comment>lawful basis</comment>
        <translation>Forschung</translation>
    </message>
    <message>
        <source>Art. 6 (1) a GDPR</source>
        <translation>Art. 6 (1) a DSGVO</translation>
    </message>
    <message>
        <source>Art. 6 (1) b GDPR</source>
        <translation>Art. 6 (1) b DSGVO</translation>
    </message>
    <message>
        <source>Art. 6 (1) c GDPR</source>
        <translation>Art. 6 (1) c DSGVO</translation>
    </message>
    <message>
        <source>Art. 6 (1) d GDPR</source>
        <translation>Art. 6 (1) d DSGVO</translation>
    </message>
    <message>
        <source>Art. 6 (1) e GDPR</source>
        <translation>Art. 6 (1) e DSGVO</translation>
    </message>
    <message>
        <source>Art. 6 (1) f GDPR</source>
        <translation>Art. 6 (1) f DSGVO</translation>
    </message>
    <message>
        <source>Art. 9 (2) h GDPR</source>
        <translation>Art. 9 (2) h DSGVO</translation>
    </message>
    <message>
        <source>Art. 9 (2) j GDPR</source>
        <translation>Art. 9 (2) j DSGVO</translation>
    </message>
    <message>
        <source>given</source>
        <translation>erteilt</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>verweigert</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>widerrufen</translation>
    </message>
    <message>
        <source>%1 %2: %3 on %4 (%5)</source>
        <translation>%1 %2: %3 am %4 (%5)</translation>
    </message>
    <message>
        <source>%1, recorded by %2</source>
        <translation>%1, eingetragen von %2</translation>
    </message>
</context>
<context>
    <name>DeviceAddress</name>
    <message>
        <source>Force sensors on a CAN bus</source>
        <translation>Kraftsensoren an einem CAN-Bus</translation>
    </message>
    <message>
        <source>Force sensors in the network</source>
        <translation>Kraftsensoren im Netzwerk</translation>
    </message>
    <message>
        <source>Force sensors on serial lines</source>
        <translation>Kraftsensoren an seriellen Leitungen</translation>
    </message>
    <message>
        <source>Cameras: Qualisys Track Manager</source>
        <translation>Kameras: Qualisys Track Manager</translation>
    </message>
    <message>
        <source>Cameras: OptiTrack Motive</source>
        <translation>Kameras: OptiTrack Motive</translation>
    </message>
    <message>
        <source>Tracked hand: Leap service</source>
        <translation>Verfolgte Hand: Leap-Dienst</translation>
    </message>
    <message>
        <source>Tracked hand: a script that sends it</source>
        <translation>Verfolgte Hand: ein Skript, das sie sendet</translation>
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
    <message>
        <source>Arm, seen by cameras …</source>
        <translation>Arm, von Kameras gesehen …</translation>
    </message>
    <message>
        <source>Simulated arm, healthy</source>
        <translation>Simulierter Arm, gesund</translation>
    </message>
    <message>
        <source>Simulated arm, paretic</source>
        <translation>Simulierter Arm, paretisch</translation>
    </message>
    <message>
        <source>Simulated tracked hand, healthy</source>
        <translation>Simulierte verfolgte Hand, gesund</translation>
    </message>
    <message>
        <source>Simulated tracked hand, paretic</source>
        <translation>Simulierte verfolgte Hand, paretisch</translation>
    </message>
    <message>
        <source>Hand, by the Leap service here</source>
        <translation>Hand, vom Leap-Dienst hier</translation>
    </message>
    <message>
        <source>Hand, by a script here</source>
        <translation>Hand, von einem Skript hier</translation>
    </message>
    <message>
        <source>Simulated, both healthy</source>
        <translation>Simuliert, beide gesund</translation>
    </message>
    <message>
        <source>Simulated, left hand paretic</source>
        <translation>Simuliert, linke Hand paretisch</translation>
    </message>
    <message>
        <source>Simulated, right hand paretic</source>
        <translation>Simuliert, rechte Hand paretisch</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simuliert: %1</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>Cameras at %1</source>
        <translation>Kameras bei %1</translation>
    </message>
    <message>
        <source>Tracked hand at %1</source>
        <translation>Verfolgte Hand bei %1</translation>
    </message>
    <message>
        <source>Add a device …</source>
        <translation>Gerät hinzufügen …</translation>
    </message>
</context>
<context>
    <name>Flow</name>
    <message>
        <source>The hand is moved as Live hand says.</source>
        <translation>Die Hand bewegt sich, wie „Hand, jetzt“ es sagt.</translation>
    </message>
    <message>
        <source>Before the first object: check that the picture moves as the hand does.</source>
        <translation>Vor dem ersten Gegenstand: prüfen, ob sich das Bild bewegt wie die Hand.</translation>
    </message>
    <message>
        <source>Check the picture first, in Live hand.</source>
        <translation>Zuerst das Bild prüfen, unter „Hand, jetzt“.</translation>
    </message>
    <message>
        <source>The object is moved as Live arm says, seen by the patient.</source>
        <translation>Der Gegenstand wird bewegt, wie „Arm jetzt“ es sagt, aus Sicht der Person.</translation>
    </message>
    <message>
        <source>Before the first target: check that the picture moves as the object does.</source>
        <translation>Vor dem ersten Ziel: prüfen, ob sich das Bild bewegt wie der Gegenstand.</translation>
    </message>
    <message>
        <source>Check the picture first, in Live arm.</source>
        <translation>Zuerst das Bild prüfen, unter „Arm jetzt“.</translation>
    </message>
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
        <translation>Stellen Sie die Sicherheitsfragen, bevor Kraft verlangt wird.</translation>
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
    <message>
        <source>The cameras send no more pictures</source>
        <translation>Die Kameras senden keine Bilder mehr</translation>
    </message>
    <message>
        <source>No pictures arrive: check the computer of the cameras</source>
        <translation>Es kommen keine Bilder an: den Rechner der Kameras prüfen</translation>
    </message>
    <message>
        <source>Waiting for the first picture …</source>
        <translation>Warten auf das erste Bild …</translation>
    </message>
    <message>
        <source>Connected, but pictures were missing</source>
        <translation>Verbunden, aber Bilder fehlten</translation>
    </message>
    <message>
        <source>Measuring the start posture …</source>
        <translation>Die Ausgangshaltung wird gemessen …</translation>
    </message>
    <message>
        <source>Connected, needs the start posture</source>
        <translation>Verbunden, braucht die Ausgangshaltung</translation>
    </message>
    <message>
        <source>The cameras send no more pictures. Disconnect to end the session.</source>
        <translation>Die Kameras senden keine Bilder mehr. Trennen Sie sie, um die Sitzung zu beenden.</translation>
    </message>
    <message>
        <source>The start posture: the arm is held still.</source>
        <translation>Die Ausgangshaltung: Der Arm wird stillgehalten.</translation>
    </message>
    <message>
        <source>Paused: the cameras sent no pictures. Resume when they are back.</source>
        <translation>Pause: Die Kameras haben keine Bilder gesendet. Weiter, wenn sie wieder da sind.</translation>
    </message>
    <message>
        <source>Start posture refused: %1</source>
        <translation>Ausgangshaltung abgelehnt: %1</translation>
    </message>
    <message>
        <source>The arm in the start posture, held still: measure it when the light says so.</source>
        <translation>Den Arm in der Ausgangshaltung stillhalten: messen, wenn das Licht es sagt.</translation>
    </message>
    <message>
        <source>Wait until the start posture is measured.</source>
        <translation>Warten, bis die Ausgangshaltung gemessen ist.</translation>
    </message>
    <message>
        <source>Measure the start posture first.</source>
        <translation>Zuerst die Ausgangshaltung messen.</translation>
    </message>
    <message>
        <source>Connecting to the cameras …</source>
        <translation>Kameras werden verbunden …</translation>
    </message>
    <message>
        <source>Which arm works today? Choose right or left.</source>
        <translation>Welcher Arm arbeitet heute? Rechts oder links wählen.</translation>
    </message>
    <message>
        <source>Ask the screening questions before any movement.</source>
        <translation>Vor jeder Bewegung die Sicherheitsfragen stellen.</translation>
    </message>
    <message>
        <source>Connect the cameras to begin the session.</source>
        <translation>Kameras verbinden, um die Sitzung zu beginnen.</translation>
    </message>
    <message>
        <source>Which hand works today? Choose right or left.</source>
        <translation>Welche Hand arbeitet heute? Rechts oder links wählen.</translation>
    </message>
    <message>
        <source>Ask the screening questions before any work.</source>
        <translation>Stellen Sie die Sicherheitsfragen, bevor gearbeitet wird.</translation>
    </message>
    <message>
        <source>Choose the device, or the cameras that see an arm.</source>
        <translation>Das Gerät wählen, oder die Kameras, die einen Arm sehen.</translation>
    </message>
    <message>
        <source>Connect the cameras first.</source>
        <translation>Zuerst die Kameras verbinden.</translation>
    </message>
    <message>
        <source>Connect a device or cameras first.</source>
        <translation>Zuerst ein Gerät oder Kameras verbinden.</translation>
    </message>
    <message>
        <source>Entry test: the hand lies still for ten seconds.</source>
        <translation>Eingangstest: Die Hand liegt zehn Sekunden still.</translation>
    </message>
    <message>
        <source>Entry test: the hand opens wide, then closes. %1 of %2.</source>
        <translation>Eingangstest: Die Hand öffnet sich weit und schließt sich. %1 von %2.</translation>
    </message>
    <message>
        <source>The tracker sends no more pictures</source>
        <translation>Die Handverfolgung sendet keine Bilder mehr</translation>
    </message>
    <message>
        <source>Nothing arrives: check the tracker and its program</source>
        <translation>Nichts kommt an: Handverfolgung und ihr Programm prüfen</translation>
    </message>
    <message>
        <source>Entry test …</source>
        <translation>Eingangstest …</translation>
    </message>
    <message>
        <source>Connected, needs the entry test</source>
        <translation>Verbunden, der Eingangstest fehlt</translation>
    </message>
    <message>
        <source>Connecting to the tracker …</source>
        <translation>Verbindung zur Handverfolgung …</translation>
    </message>
    <message>
        <source>Connect the tracker to begin the session.</source>
        <translation>Handverfolgung verbinden, um die Sitzung zu beginnen.</translation>
    </message>
    <message>
        <source>The tracker sends no more pictures. Disconnect to end the session.</source>
        <translation>Die Handverfolgung sendet keine Bilder mehr. Trennen beendet die Sitzung.</translation>
    </message>
    <message>
        <source>Paused: the tracker sent no hand. Resume when it works again.</source>
        <translation>Angehalten: Die Handverfolgung sendete keine Hand. Fortsetzen, wenn sie wieder arbeitet.</translation>
    </message>
    <message>
        <source>The hand is not seen. The trial goes on by itself.</source>
        <translation>Die Hand ist nicht zu sehen. Der Versuch geht von selbst weiter.</translation>
    </message>
    <message>
        <source>The hand lies on the table before the tracker: begin the entry test.</source>
        <translation>Die Hand liegt vor der Kamera auf dem Tisch: Eingangstest beginnen.</translation>
    </message>
    <message>
        <source>Connect the tracker first.</source>
        <translation>Zuerst die Handverfolgung verbinden.</translation>
    </message>
    <message>
        <source>Do the entry test first.</source>
        <translation>Zuerst den Eingangstest machen.</translation>
    </message>
    <message>
        <source>No virtual objects for this hand: its entry test says so.</source>
        <translation>Keine virtuellen Objekte für diese Hand: So sagt es ihr Eingangstest.</translation>
    </message>
    <message>
        <source>Wait until the entry test is over.</source>
        <translation>Warten, bis der Eingangstest vorbei ist.</translation>
    </message>
    <message>
        <source>Left platform: %1</source>
        <translation>Linke Plattform: %1</translation>
    </message>
    <message>
        <source>Right platform: %1</source>
        <translation>Rechte Plattform: %1</translation>
    </message>
    <message>
        <source>Ask the screening questions of each hand before any force.</source>
        <translation>Stellen Sie die Sicherheitsfragen zu jeder Hand, bevor Kraft verlangt wird.</translation>
    </message>
    <message>
        <source>Connecting to both platforms …</source>
        <translation>Verbindung mit beiden Plattformen …</translation>
    </message>
    <message>
        <source>Choose the platform of each hand.</source>
        <translation>Wählen Sie die Plattform jeder Hand.</translation>
    </message>
    <message>
        <source>Connect both platforms to begin the session.</source>
        <translation>Verbinden Sie beide Plattformen, um die Sitzung zu beginnen.</translation>
    </message>
    <message>
        <source>Before the hands go in: press the pedal (F9) or the stop key (F10) once, as a test.</source>
        <translation>Bevor die Hände hineinkommen: zur Probe einmal das Pedal (F9) oder die Stopptaste (F10) drücken.</translation>
    </message>
    <message>
        <source>The stop works. Confirm that you stay within reach.</source>
        <translation>Der Stopp geht. Bestätigen Sie, dass Sie in Reichweite bleiben.</translation>
    </message>
    <message>
        <source>Put both hands in and say so; after a minute the resting force begins.</source>
        <translation>Beide Hände hineinlegen und bestätigen; nach einer Minute beginnt die Ruhekraft.</translation>
    </message>
    <message>
        <source>Put both hands in and say so; after a minute start the resting force.</source>
        <translation>Beide Hände hineinlegen und bestätigen; nach einer Minute die Ruhekraft starten.</translation>
    </message>
    <message>
        <source>Both zeros are set. Put both hands in again and say so.</source>
        <translation>Beide Nullabgleiche sind erfolgt. Beide Hände wieder hineinlegen und bestätigen.</translation>
    </message>
    <message>
        <source>Both hands are in. They settle: %1 s, then the resting force begins.</source>
        <translation>Beide Hände liegen. Sie kommen zur Ruhe: noch %1 s, dann beginnt die Ruhekraft.</translation>
    </message>
    <message>
        <source>Both hands are in. They settle: %1 s until the resting force.</source>
        <translation>Beide Hände liegen. Sie kommen zur Ruhe: noch %1 s bis zur Ruhekraft.</translation>
    </message>
    <message>
        <source>The hands have settled. They relax: start the resting force.</source>
        <translation>Die Hände sind zur Ruhe gekommen. Sie entspannen: die Ruhekraft starten.</translation>
    </message>
    <message>
        <source>The straps have been on for 20 minutes: look at the skin, then confirm that the hands are in.</source>
        <translation>Die Gurte sitzen seit 20 Minuten: Sehen Sie die Haut an und bestätigen Sie dann, dass die Hände liegen.</translation>
    </message>
    <message>
        <source>A platform sends no more forces</source>
        <translation>Eine Plattform sendet keine Kräfte mehr</translation>
    </message>
    <message>
        <source>No forces arrive: check cable and power of both platforms</source>
        <translation>Es kommen keine Kräfte an: Kabel und Stromversorgung beider Plattformen prüfen</translation>
    </message>
    <message>
        <source>Measuring both empty platforms …</source>
        <translation>Beide leeren Plattformen werden gemessen …</translation>
    </message>
    <message>
        <source>Connected, both need their zero</source>
        <translation>Verbunden, beiden fehlt der Nullabgleich</translation>
    </message>
    <message>
        <source>A platform sends no more forces. Disconnect to end the session.</source>
        <translation>Eine Plattform sendet keine Kräfte mehr. Trennen Sie, um die Sitzung zu beenden.</translation>
    </message>
    <message>
        <source>Setting both zeros. Nobody touches the platforms.</source>
        <translation>Beide Nullabgleiche laufen. Niemand berührt die Plattformen.</translation>
    </message>
    <message>
        <source>Both platforms connected. Set their zeros with both empty.</source>
        <translation>Beide Plattformen verbunden. Nullabgleich machen, während beide leer sind.</translation>
    </message>
    <message>
        <source>Take both hands out, then set the zeros of the empty platforms once more.</source>
        <translation>Beide Hände herausnehmen, dann den Nullabgleich der leeren Plattformen noch einmal machen.</translation>
    </message>
    <message>
        <source>The device works again. Both hands let go; if Resume stays closed, stop, set the zeros and repeat the trial.</source>
        <translation>Das Gerät arbeitet wieder. Beide Hände lassen los; bleibt „Weitermachen“ gesperrt, beenden, Nullabgleich machen und den Versuch wiederholen.</translation>
    </message>
    <message>
        <source>%1 Next: the maxima of both hands.</source>
        <translation>%1 Als Nächstes: die Maxima beider Hände.</translation>
    </message>
    <message>
        <source>Resting forces are known.</source>
        <translation>Die Ruhekräfte sind bekannt.</translation>
    </message>
    <message>
        <source>The maxima are known. Choose a task and press Start.</source>
        <translation>Die Maxima sind bekannt. Wählen Sie eine Aufgabe und drücken Sie Start.</translation>
    </message>
    <message>
        <source>Connect both platforms first.</source>
        <translation>Verbinden Sie zuerst beide Plattformen.</translation>
    </message>
    <message>
        <source>Set both zeros first, with both empty.</source>
        <translation>Machen Sie zuerst den Nullabgleich, während beide leer sind.</translation>
    </message>
    <message>
        <source>Wait until both zeros are set.</source>
        <translation>Warten Sie, bis beide Nullabgleiche fertig sind.</translation>
    </message>
    <message>
        <source>Set the zeros of the empty platforms once more.</source>
        <translation>Machen Sie den Nullabgleich der leeren Plattformen noch einmal.</translation>
    </message>
    <message>
        <source>Press the pedal (F9) or F10 once, as a test.</source>
        <translation>Drücken Sie zur Probe einmal das Pedal (F9) oder F10.</translation>
    </message>
    <message>
        <source>Confirm first that you stay within reach.</source>
        <translation>Bestätigen Sie zuerst, dass Sie in Reichweite bleiben.</translation>
    </message>
    <message>
        <source>Say first that both hands are in.</source>
        <translation>Bestätigen Sie zuerst, dass beide Hände liegen.</translation>
    </message>
    <message>
        <source>The hands settle: %1 s.</source>
        <translation>Die Hände kommen zur Ruhe: %1 s.</translation>
    </message>
    <message>
        <source>One platform is pressed, nobody touches the other.</source>
        <translation>Eine Plattform wird gedrückt, niemand berührt die andere.</translation>
    </message>
    <message>
        <source>Both zeros are set. Check whether the empty platforms move each other.</source>
        <translation>Beide Nullabgleiche sind erfolgt. Prüfen Sie, ob sich die leeren Plattformen gegenseitig bewegen.</translation>
    </message>
    <message>
        <source>Check the platforms first, or skip that check.</source>
        <translation>Prüfen Sie zuerst die Plattformen, oder lassen Sie das aus.</translation>
    </message>
    <message>
        <source>The protocol is finished. Print or write the report, then end the session.</source>
        <translation>Das Protokoll ist beendet. Bericht drucken oder schreiben, dann die Sitzung beenden.</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Achtung</translation>
    </message>
    <message>
        <source>The protocol is finished. Write the report, or disconnect to end.</source>
        <translation>Das Protokoll ist beendet. Schreiben Sie den Bericht oder trennen Sie die Verbindung.</translation>
    </message>
    <message>
        <source>Ask the screening questions for the other arm. The cameras then connect by themselves.</source>
        <translation>Stellen Sie die Sicherheitsfragen zum anderen Arm. Danach verbinden sich die Kameras von selbst.</translation>
    </message>
    <message>
        <source>Ask the screening questions for the other hand. The device then connects by itself.</source>
        <translation>Stellen Sie die Sicherheitsfragen zur anderen Hand. Danach verbindet sich das Gerät von selbst.</translation>
    </message>
</context>
<context>
    <name>FlowFault</name>
    <message>
        <source>All that was measured is stored.</source>
        <translation>Alles Gemessene ist gespeichert.</translation>
    </message>
    <message>
        <source>The trial stands still.</source>
        <translation>Der Versuch steht still.</translation>
    </message>
    <message>
        <source>The trial stands still; all up to %1 is stored.</source>
        <translation>Der Versuch steht still; alles bis %1 ist gespeichert.</translation>
    </message>
    <message>
        <source>No session has begun, and nothing was changed.</source>
        <translation>Es hat keine Sitzung begonnen, und nichts wurde verändert.</translation>
    </message>
    <message>
        <source>What is kept, and where, is said below.</source>
        <translation>Was erhalten ist, und wo, steht darunter.</translation>
    </message>
    <message>
        <source>All up to %1 is stored.</source>
        <translation>Alles bis %1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Look at cables and power. Try again ends this session; the next one begins with the questions before it.</source>
        <translation>Sehen Sie nach Kabeln und Strom. Noch einmal beendet diese Sitzung; die nächste beginnt mit den Fragen davor.</translation>
    </message>
    <message>
        <source>Look at cables and power of the device. Try again ends this session; the next one begins with the questions before it.</source>
        <translation>Sehen Sie nach Kabeln und Strom des Geräts. Noch einmal beendet diese Sitzung; die nächste beginnt mit den Fragen davor.</translation>
    </message>
    <message>
        <source>Look at cables and power: it goes on when data arrive again.</source>
        <translation>Sehen Sie nach Kabeln und Strom: Es geht weiter, sobald wieder Daten kommen.</translation>
    </message>
    <message>
        <source>Resume when the picture is back.</source>
        <translation>Fahren Sie fort, wenn das Bild wieder da ist.</translation>
    </message>
    <message>
        <source>When it works again, the hand lets go; then resume. If Resume stays closed: stop, set the zero, repeat the trial.</source>
        <translation>Wenn es wieder geht, lässt die Hand los; dann geht es weiter. Bleibt „Weitermachen“ gesperrt: beenden, Nullabgleich setzen, den Versuch wiederholen.</translation>
    </message>
</context>
<context>
    <name>Hand</name>
    <message>
        <source>%1: let go as well, the object was placed</source>
        <translation>%1: ebenfalls losgelassen, der Gegenstand war abgelegt</translation>
    </message>
    <message>
        <source>%1: tied, this grasp holds (%2)</source>
        <translation>%1: verbunden, dieser Griff hält (%2)</translation>
    </message>
    <message>
        <source>%1: tied, the grasp of %2 holds (%3)</source>
        <translation>%1: verbunden, der Griff von %2 hält (%3)</translation>
    </message>
    <message>
        <source>%1: let go, pulled with %2 N &gt; %3 N</source>
        <translation>%1: losgelassen, Zug %2 N &gt; %3 N</translation>
    </message>
    <message>
        <source>%1: let go, what was left held nothing</source>
        <translation>%1: losgelassen, was übrig war, hielt nichts</translation>
    </message>
    <message>
        <source>%1: let go for the person</source>
        <translation>%1: für die Person losgelassen</translation>
    </message>
    <message>
        <source>The object was dropped</source>
        <translation>Das Objekt fiel</translation>
    </message>
    <message>
        <source>%1: loose, the placement is over</source>
        <translation>%1: frei, die Platzierung ist zu Ende</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 %2 &gt; %3</source>
        <translation>%1 %2 &gt; %3</translation>
    </message>
    <message>
        <source>G min</source>
        <translation>G min</translation>
    </message>
    <message>
        <source>H min</source>
        <translation>H min</translation>
    </message>
    <message>
        <source>H det</source>
        <translation>H det</translation>
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
        <source>Ring finger</source>
        <translation>Ringfinger</translation>
    </message>
    <message>
        <source>Little finger</source>
        <translation>Kleinfinger</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>berührt</translation>
    </message>
    <message>
        <source>tied</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>has let go</source>
        <translation>losgelassen</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
    <message>
        <source>softer</source>
        <translation>weicher</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>HandScreening</name>
    <message>
        <source>Shoulder pain or subluxation</source>
        <translation>Schulterschmerz oder Subluxation</translation>
    </message>
    <message>
        <source>The hand is carried to its targets: support the forearm</source>
        <translation>Die Hand wird zu ihren Zielen geführt: Unterarm stützen</translation>
    </message>
    <message>
        <source>Stop where the shoulder hurts.</source>
        <translation>Aufhören, wo die Schulter schmerzt.</translation>
    </message>
    <message>
        <source>Support the forearm; stop where the shoulder hurts.</source>
        <translation>Unterarm stützen; aufhören, wo die Schulter schmerzt.</translation>
    </message>
    <message>
        <source>Mark the treatment on the patient&apos;s page.</source>
        <translation>Die Behandlung auf der Seite des Patienten eintragen.</translation>
    </message>
    <message>
        <source>Stay beside the patient.</source>
        <translation>Beim Patienten bleiben.</translation>
    </message>
    <message>
        <source>may move, pain %1</source>
        <translation>darf sich bewegen, Schmerz %1</translation>
    </message>
    <message>
        <source>no movement, pain %1</source>
        <translation>keine Bewegung, Schmerz %1</translation>
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
    <message>
        <source>Start posture</source>
        <translation>Ausgangshaltung</translation>
    </message>
    <message>
        <source>Entry test of the hand</source>
        <translation>Eingangstest der Hand</translation>
    </message>
    <message>
        <source>Postures</source>
        <translation>Haltungen</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>left, mirrored</source>
        <translation>links, gespiegelt</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>An own task names them</source>
        <translation>Eine eigene Aufgabe nennt sie</translation>
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
        <source>Relax your arm.</source>
        <translation>Arm entspannen.</translation>
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
        <source>Relax your arm</source>
        <translation>Arm entspannen</translation>
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
        <source>Pause. Relax your arm.</source>
        <translation>Pause. Entspannen Sie den Arm.</translation>
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
    <message>
        <source>Turn the hand towards the cameras</source>
        <translation>Wenden Sie die Hand den Kameras zu</translation>
    </message>
    <message>
        <source>It goes on by itself</source>
        <translation>Es geht von selbst weiter</translation>
    </message>
    <message>
        <source>Stay there until the next picture</source>
        <translation>Bleiben Sie dort bis zum nächsten Bild</translation>
    </message>
    <message>
        <source>Hold your arm still</source>
        <translation>Halten Sie den Arm still</translation>
    </message>
    <message>
        <source>For a moment, in the start posture</source>
        <translation>Einen Moment, in der Ausgangshaltung</translation>
    </message>
    <message>
        <source>Take it in your hand again</source>
        <translation>Nehmen Sie es wieder in die Hand</translation>
    </message>
    <message>
        <source>As far as it goes.</source>
        <translation>So weit es geht.</translation>
    </message>
    <message>
        <source>Close your hand</source>
        <translation>Hand schließen</translation>
    </message>
    <message>
        <source>The cameras need help. You did nothing wrong. Relax your arm.</source>
        <translation>Die Kameras brauchen Hilfe. Sie haben nichts falsch gemacht. Entspannen Sie den Arm.</translation>
    </message>
    <message>
        <source>Please show your right hand</source>
        <translation>Bitte die rechte Hand zeigen</translation>
    </message>
    <message>
        <source>Please show your left hand</source>
        <translation>Bitte die linke Hand zeigen</translation>
    </message>
    <message>
        <source>Show your hand to the camera</source>
        <translation>Zeigen Sie die Hand der Kamera</translation>
    </message>
    <message>
        <source>It appears here by itself</source>
        <translation>Sie erscheint hier von selbst</translation>
    </message>
    <message>
        <source>Your hand is out of sight</source>
        <translation>Die Hand ist nicht zu sehen</translation>
    </message>
    <message>
        <source>It stands still here and goes on by itself</source>
        <translation>Sie steht hier still, es geht von selbst weiter</translation>
    </message>
    <message>
        <source>The next object comes in a moment</source>
        <translation>Gleich kommt der nächste Gegenstand</translation>
    </message>
    <message>
        <source>The object lets go by itself</source>
        <translation>Der Gegenstand löst sich von selbst</translation>
    </message>
    <message>
        <source>It is in place: open your hand</source>
        <translation>Er ist am Platz: Hand öffnen</translation>
    </message>
    <message>
        <source>Lift your hand</source>
        <translation>Hand anheben</translation>
    </message>
    <message>
        <source>It is below the table</source>
        <translation>Sie ist unter dem Tisch</translation>
    </message>
    <message>
        <source>Bring it to the blue shape</source>
        <translation>An die blaue Form bringen</translation>
    </message>
    <message>
        <source>The line shows the way</source>
        <translation>Die Linie zeigt den Weg</translation>
    </message>
    <message>
        <source>Take the object</source>
        <translation>Gegenstand greifen</translation>
    </message>
    <message>
        <source>Then bring it to the blue shape</source>
        <translation>Dann an die blaue Form bringen</translation>
    </message>
    <message>
        <source>As far as it goes</source>
        <translation>So weit es geht</translation>
    </message>
    <message>
        <source>Rest your hand</source>
        <translation>Hand ruhen lassen</translation>
    </message>
    <message>
        <source>Keep it still, where it can be seen</source>
        <translation>Still und gut sichtbar halten</translation>
    </message>
    <message>
        <source>Opened %1 of %2 times</source>
        <translation>%1 von %2 Mal geöffnet</translation>
    </message>
    <message>
        <source>Help: full</source>
        <translation>Hilfe: voll</translation>
    </message>
    <message>
        <source>Help: a little</source>
        <translation>Hilfe: ein wenig</translation>
    </message>
    <message>
        <source>Without help</source>
        <translation>Ohne Hilfe</translation>
    </message>
    <message>
        <source>The camera needs help. You did nothing wrong. Relax your hand.</source>
        <translation>Die Kamera braucht Hilfe. Sie haben nichts falsch gemacht. Entspannen Sie die Hand.</translation>
    </message>
    <message>
        <source>Relax both hands.</source>
        <translation>Entspannen Sie beide Hände.</translation>
    </message>
    <message>
        <source>The device needs help. You did nothing wrong. Relax both hands.</source>
        <translation>Das Gerät braucht Hilfe. Sie haben nichts falsch gemacht. Entspannen Sie beide Hände.</translation>
    </message>
    <message>
        <source>Pause. Relax both hands.</source>
        <translation>Pause. Entspannen Sie beide Hände.</translation>
    </message>
    <message>
        <source>squeezes</source>
        <translation>drückt kräftig</translation>
    </message>
    <message>
        <source>presses</source>
        <translation>drückt</translation>
    </message>
    <message>
        <source>at rest</source>
        <comment>the other hand works</comment>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>rests</source>
        <translation>ruht</translation>
    </message>
    <message>
        <source>Next: both hands</source>
        <translation>Als Nächstes: beide Hände</translation>
    </message>
    <message>
        <source>Next: left hand</source>
        <translation>Als Nächstes: linke Hand</translation>
    </message>
    <message>
        <source>Next: right hand</source>
        <translation>Als Nächstes: rechte Hand</translation>
    </message>
    <message>
        <source>Let both hands rest</source>
        <translation>Beide Hände ruhen lassen</translation>
    </message>
    <message>
        <source>Squeeze with both hands!</source>
        <translation>Mit beiden Händen zudrücken!</translation>
    </message>
    <message>
        <source>Squeeze with the left hand!</source>
        <translation>Mit der linken Hand zudrücken!</translation>
    </message>
    <message>
        <source>Squeeze with the right hand!</source>
        <translation>Mit der rechten Hand zudrücken!</translation>
    </message>
    <message>
        <source>Press with both hands</source>
        <translation>Mit beiden Händen drücken</translation>
    </message>
    <message>
        <source>Together up to the line</source>
        <translation>Gemeinsam bis zur Linie</translation>
    </message>
    <message>
        <source>Each hand up to its line</source>
        <translation>Jede Hand bis zu ihrer Linie</translation>
    </message>
    <message>
        <source>Press with the left hand</source>
        <translation>Mit der linken Hand drücken</translation>
    </message>
    <message>
        <source>Press with the right hand</source>
        <translation>Mit der rechten Hand drücken</translation>
    </message>
    <message>
        <source>Other hand at rest</source>
        <translation>Andere Hand in Ruhe</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Gemeinsam</translation>
    </message>
    <message>
        <source>The devices measure themselves.</source>
        <translation>Die Geräte messen sich selbst.</translation>
    </message>
    <message>
        <source>Please take both hands out of the devices</source>
        <translation>Bitte beide Hände aus den Geräten nehmen</translation>
    </message>
    <message>
        <source>Relax both hands</source>
        <translation>Beide Hände entspannen</translation>
    </message>
    <message>
        <source>Press the ends together</source>
        <translation>Drücken Sie die Enden zusammen</translation>
    </message>
    <message>
        <source>It slides: press more firmly</source>
        <translation>Es rutscht: fester drücken</translation>
    </message>
    <message>
        <source>Then lift it with both hands</source>
        <translation>Dann heben Sie es mit beiden Händen</translation>
    </message>
    <message>
        <source>Lift it with both hands</source>
        <translation>Heben Sie es mit beiden Händen</translation>
    </message>
    <message>
        <source>The left end is too low</source>
        <translation>Das linke Ende ist zu tief</translation>
    </message>
    <message>
        <source>The right end is too low</source>
        <translation>Das rechte Ende ist zu tief</translation>
    </message>
    <message>
        <source>Level, into the band</source>
        <translation>Waagerecht, in das Band</translation>
    </message>
    <message>
        <source>It slipped: let both hands rest</source>
        <translation>Es ist gerutscht: Lassen Sie beide Hände ruhen</translation>
    </message>
    <message>
        <source>You may lift it again in a moment</source>
        <translation>Gleich dürfen Sie es wieder heben</translation>
    </message>
    <message>
        <source>lifts</source>
        <translation>hebt</translation>
    </message>
    <message>
        <source>Carry it to the outline</source>
        <translation>Tragen Sie sie in den Umriss</translation>
    </message>
    <message>
        <source>It was let go: let both hands rest</source>
        <translation>Sie wurde losgelassen: beide Hände ruhen lassen</translation>
    </message>
    <message>
        <source>Keep pressing from both sides</source>
        <translation>Drücken Sie weiter von beiden Seiten</translation>
    </message>
    <message>
        <source>One from each side</source>
        <translation>Von jeder Seite eine</translation>
    </message>
    <message>
        <source>Press both hands against the box</source>
        <translation>Drücken Sie beide Hände gegen die Kiste</translation>
    </message>
    <message>
        <source>Relax them, then leave the pedal</source>
        <translation>Entspannen Sie sie, dann lassen Sie das Pedal los</translation>
    </message>
    <message>
        <source>You may take it again in a moment</source>
        <translation>Gleich dürfen Sie sie wieder nehmen</translation>
    </message>
    <message>
        <source>Your hands stay where they are</source>
        <translation>Ihre Hände bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>carries</source>
        <translation>trägt</translation>
    </message>
    <message>
        <source>lets go</source>
        <translation>lässt los</translation>
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
    <message>
        <source>Start posture, arm held still</source>
        <translation>Ausgangshaltung, Arm stillgehalten</translation>
    </message>
    <message>
        <source>Entry test of the hand</source>
        <translation>Eingangstest der Hand</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Pull of the fingers on their ties</source>
        <translation>Zug der Finger an ihren Verbindungen</translation>
    </message>
    <message>
        <source>Opening of the hand</source>
        <translation>Öffnung der Hand</translation>
    </message>
    <message>
        <source>lets go above</source>
        <translation>löst sich über</translation>
    </message>
    <message>
        <source>Thumb to index</source>
        <translation>Daumen bis Zeigefinger</translation>
    </message>
    <message>
        <source>The hand cannot be drawn: %1.</source>
        <translation>Die Hand kann nicht gezeichnet werden: %1.</translation>
    </message>
    <message>
        <source>Size of the hand</source>
        <translation>Größe der Hand</translation>
    </message>
    <message>
        <source>usual: not measured</source>
        <translation>übliche: nicht gemessen</translation>
    </message>
    <message>
        <source>without the hand</source>
        <translation>ohne die Hand</translation>
    </message>
    <message>
        <source>of the other hand</source>
        <translation>von der anderen Hand</translation>
    </message>
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
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Target of the left hand</source>
        <translation>Ziel der linken Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Target of the right hand</source>
        <translation>Ziel der rechten Hand</translation>
    </message>
    <message>
        <source>Both hands</source>
        <translation>Beide Hände</translation>
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
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>both hands</source>
        <translation>beide Hände</translation>
    </message>
    <message>
        <source>The arm cannot be drawn: %1.</source>
        <translation>Der Arm kann nicht gezeichnet werden: %1.</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Start posture</source>
        <translation>Ausgangshaltung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Angles of the forearm</source>
        <translation>Winkel des Unterarms</translation>
    </message>
    <message>
        <source>Angles of the wrist</source>
        <translation>Winkel des Handgelenks</translation>
    </message>
    <message>
        <source>Angles of the fingers</source>
        <translation>Winkel der Finger</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Winkel %1</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1&#xa0;cm</translation>
    </message>
    <message>
        <source>Camera on</source>
        <translation>Kamera an</translation>
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
    <name>ScenePreview</name>
    <message>
        <source>%1 reach the end of the pad</source>
        <translation>%1 reichen bis ans Ende der Kuppe</translation>
    </message>
    <message>
        <source>%1 stop at an edge</source>
        <translation>%1 enden an einer Kante</translation>
    </message>
    <message>
        <source>%1 stop where friction no longer holds</source>
        <translation>%1 enden, wo die Reibung nicht mehr hält</translation>
    </message>
    <message>
        <source>%1 stop where the surface ends</source>
        <translation>%1 enden, wo die Fläche endet</translation>
    </message>
    <message>
        <source>covers %1 of the %2 mm² of the pad</source>
        <translation>bedeckt %1 der %2 mm² der Kuppe</translation>
    </message>
    <message>
        <source>middle: %1 mm along the tangent, %2 mm across it</source>
        <translation>Mitte: %1 mm längs der Tangente, %2 mm quer dazu</translation>
    </message>
    <message>
        <source>torsion: at most %1 N mm for each newton of pressure, %2 as a pure torque</source>
        <translation>Torsion: höchstens %1 N mm je Newton Druck, %2 als reines Drehmoment</translation>
    </message>
    <message>
        <source>of %1 rays: %2</source>
        <translation>von %1 Strahlen: %2</translation>
    </message>
    <message>
        <source>Pad: %1</source>
        <translation>Kuppe: %1</translation>
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
        <source>Moves</source>
        <translation>Bewegt sich</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Dreht sich</translation>
    </message>
    <message>
        <source>Forces act in</source>
        <translation>Kräfte wirken in</translation>
    </message>
    <message>
        <source>Limits of travel</source>
        <translation>Bewegungsgrenzen</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Grasp rule</source>
        <translation>Griffregel</translation>
    </message>
    <message>
        <source>Held firmly by</source>
        <translation>Fest gehalten von</translation>
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
        <source>press without an object</source>
        <translation>drücken ohne Objekt</translation>
    </message>
    <message>
        <source>press the object with their forces</source>
        <translation>drücken das Objekt mit ihren Kräften</translation>
    </message>
    <message>
        <source>are points that forces move</source>
        <translation>sind Punkte, die Kräfte bewegen</translation>
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
        <source>L</source>
        <comment>left hand</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right hand</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Two hands</source>
        <translation>Zwei Hände</translation>
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
    <name>isograsp::gui::AddDeviceDialog</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 answers. Its camera is looked at in a session only, once a lawful basis is on record.</source>
        <translation>%1 antwortet. Durch die Kamera wird erst in einer Sitzung gesehen, wenn eine Rechtsgrundlage eingetragen ist.</translation>
    </message>
    <message>
        <source>%1. Works: %2 times a second, nothing missing.</source>
        <translation>%1. Funktioniert: %2-mal in der Sekunde, nichts fehlt.</translation>
    </message>
    <message>
        <source>%1 answers, but sends nothing whole: look at cables and power.</source>
        <translation>%1 antwortet, sendet aber nichts Ganzes: Sehen Sie nach Kabeln und Strom.</translation>
    </message>
    <message>
        <source>%1 answers, but parts are missing in %2 of %3 looks.</source>
        <translation>%1 antwortet, aber bei %2 von %3 Blicken fehlt etwas.</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>Gerät hinzufügen</translation>
    </message>
    <message>
        <source>Add the device</source>
        <translation>Gerät hinzufügen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>How the device is reached (arrow keys)</source>
        <translation>Wie das Gerät erreicht wird (Pfeiltasten)</translation>
    </message>
    <message>
        <source>Maker</source>
        <translation>Hersteller</translation>
    </message>
    <message>
        <source>Whose sensors they are (arrow keys)</source>
        <translation>Wessen Sensoren es sind (Pfeiltasten)</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Choose or type; empty: Find looks for it (Tab)</source>
        <translation>Wählen oder eingeben; leer: Suchen findet es (Tab)</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>The file that says how the sensors are mounted and set (arrow keys)</source>
        <translation>Die Datei, die sagt, wie die Sensoren montiert und eingestellt sind (Pfeiltasten)</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Markersatz</translation>
    </message>
    <message>
        <source>What the markers are stuck to (arrow keys)</source>
        <translation>Worauf die Marker kleben (Pfeiltasten)</translation>
    </message>
    <message>
        <source>Room 2</source>
        <translation>Raum 2</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What people here call it (Tab)</source>
        <translation>Wie man es hier nennt (Tab)</translation>
    </message>
    <message>
        <source>&amp;Find</source>
        <translation>&amp;Suchen</translation>
    </message>
    <message>
        <source>Find what answers</source>
        <translation>Suchen, was antwortet</translation>
    </message>
    <message>
        <source>Asks every place where such a device could be (Alt+F)</source>
        <translation>Fragt überall, wo ein solches Gerät sein könnte (Alt+S)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>Check the device</source>
        <translation>Das Gerät prüfen</translation>
    </message>
    <message>
        <source>Opens it, looks at it for a second and lets it go; nothing is recorded (Alt+C)</source>
        <translation>Öffnet es, sieht es sich eine Sekunde an und lässt es los; nichts wird aufgezeichnet (Alt+P)</translation>
    </message>
    <message>
        <source>Asking</source>
        <translation>Fragt</translation>
    </message>
    <message>
        <source>192.168.1.1: the first of three in a row, or all three</source>
        <translation>192.168.1.1: die erste von drei folgenden, oder alle drei</translation>
    </message>
    <message>
        <source>three ports, with commas</source>
        <translation>drei Anschlüsse, mit Kommas</translation>
    </message>
    <message>
        <source>as delivered</source>
        <translation>wie geliefert</translation>
    </message>
    <message>
        <source>Another device has this name.</source>
        <translation>So heißt schon ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Asking %1 …</source>
        <translation>Fragt %1 …</translation>
    </message>
    <message>
        <source>Nothing answers. Asked last: %1</source>
        <translation>Nichts antwortet. Zuletzt gefragt: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ArmPanel</name>
    <message>
        <source>Off by &lt;b&gt;%1&lt;/b&gt;, &lt;b&gt;%2&lt;/b&gt;; %3 mm of it in depth</source>
        <translation>Abstand &lt;b&gt;%1&lt;/b&gt;, &lt;b&gt;%2&lt;/b&gt;; davon %3 mm in der Tiefe</translation>
    </message>
    <message>
        <source>%1 of %2 mm</source>
        <translation>%1 von %2 mm</translation>
    </message>
    <message>
        <source>%1° of %2°</source>
        <translation>%1° von %2°</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Live arm</source>
        <translation>Arm jetzt</translation>
    </message>
    <message>
        <source>Left arm: targets are those of a right one in the mirror; a screw turns the other way.</source>
        <translation>Linker Arm: Die Ziele sind die eines rechten im Spiegel; eine Schraube dreht anders herum.</translation>
    </message>
    <message>
        <source>From the object to its target, beside what counts as there. Depth is along the line of sight: without a second picture for the other eye it is harder to see</source>
        <translation>Vom Gegenstand zum Ziel, daneben was als erreicht gilt. Tiefe liegt in Blickrichtung: Ohne ein zweites Bild für das andere Auge ist sie schwerer zu sehen</translation>
    </message>
    <message>
        <source>%1: share of the turn</source>
        <translation>%1: Anteil an der Drehung</translation>
    </message>
    <message>
        <source>%1: how far it has turned since the target appeared, as a share of all three</source>
        <translation>%1: wie weit es sich gedreht hat, seit das Ziel erschien, als Anteil aller drei</translation>
    </message>
    <message>
        <source>The arm is shown once the cameras are connected.</source>
        <translation>Der Arm erscheint, sobald die Kameras verbunden sind.</translation>
    </message>
    <message>
        <source>No trial is running.</source>
        <translation>Es läuft kein Versuch.</translation>
    </message>
    <message>
        <source>The start posture has not been measured yet.</source>
        <translation>Die Ausgangshaltung ist noch nicht gemessen.</translation>
    </message>
    <message>
        <source>Turned from %1° to %2°, now %3</source>
        <translation>Gedreht von %1° bis %2°, jetzt %3</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>The range begins in a moment.</source>
        <translation>Der Bewegungsumfang beginnt gleich.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2&lt;/b&gt; reached</source>
        <translation>&lt;b&gt;%1 von %2&lt;/b&gt; erreicht</translation>
    </message>
    <message>
        <source>The object is not seen, or no target is shown.</source>
        <translation>Der Gegenstand ist nicht zu sehen, oder es gibt kein Ziel.</translation>
    </message>
    <message>
        <source>Pictures %1   ·   lost %2   ·   damaged %3   ·   late %L4 ms</source>
        <translation>Bilder %1   ·   verloren %2   ·   beschädigt %3   ·   verspätet %L4 ms</translation>
    </message>
    <message>
        <source>Practice %1 of %2 on a first visit; bout %3: %4 of %5.</source>
        <translation>Übung %1 von %2 beim ersten Besuch; Runde %3: %4 von %5.</translation>
    </message>
    <message>
        <source>%1 Last two movements %2 % apart: ✓ enough on a later visit.</source>
        <translation>%1 Letzte zwei Bewegungen %2 % auseinander: ✓ genug bei späteren Besuchen.</translation>
    </message>
    <message>
        <source>%1 Last two movements %2 % apart: one more on a later visit.</source>
        <translation>%1 Letzte zwei Bewegungen %2 % auseinander: bei späteren Besuchen noch eine.</translation>
    </message>
    <message>
        <source>On a first visit 15 minutes, in bouts of 3 with a rest between them; later until two movements on end differ by less than 10 %, four at most. Practice is work, too</source>
        <translation>Beim ersten Besuch 15 Minuten, in Runden von 3 mit einer Pause dazwischen; später, bis zwei Bewegungen hintereinander um weniger als 10 % verschieden sind, höchstens vier. Auch Übung ist Arbeit</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ArmScreeningForm</name>
    <message>
        <source>Can do both, no &amp;pain</source>
        <translation>Kann beides, kein Schmer&amp;z</translation>
    </message>
    <message>
        <source>Can do both, no pain, nothing else: own range</source>
        <translation>Kann beides, kein Schmerz, sonst nichts: eigener Umfang</translation>
    </message>
    <message>
        <source>No shoulder pain, no contracture, no tape allergy; turns by 10° and holds for 10 s (Alt+P)</source>
        <translation>Kein Schulterschmerz, keine Kontraktur, keine Pflasterallergie; dreht um 10° und hält 10 s (Alt+Z)</translation>
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
        <source>Passive range, as far as measured</source>
        <translation>Passiver Umfang, soweit gemessen</translation>
    </message>
    <message>
        <source>%1: passive range measured</source>
        <translation>%1: passiver Umfang gemessen</translation>
    </message>
    <message>
        <source>No target goes beyond this range (Tab, then space)</source>
        <translation>Kein Ziel geht über diesen Umfang hinaus (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>%1, passive, in degrees</source>
        <translation>%1, passiv, in Grad</translation>
    </message>
    <message>
        <source>From neutral, thumb up; negative: neutral is not reached (Tab, arrow keys)</source>
        <translation>Ab Neutralstellung, Daumen oben; negativ: die Neutralstellung wird nicht erreicht (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>You decide for this arm</source>
        <translation>Sie entscheiden für diesen Arm</translation>
    </message>
    <message>
        <source>%1 of this arm today (Tab, then space)</source>
        <translation>%1 dieses Arms heute (Tab, dann Leertaste)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ArmViews</name>
    <message>
        <source>The arm from the front, from the side and from above</source>
        <translation>Der Arm von vorn, von der Seite und von oben</translation>
    </message>
    <message>
        <source>Markers, the chain from elbow to object, the object (full line) and its target (dashed); one square of the grid is 10 cm</source>
        <translation>Marker, die Kette vom Ellbogen zum Gegenstand, der Gegenstand (durchgezogen) und sein Ziel (gestrichelt); ein Kästchen des Gitters ist 10 cm</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
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
    <name>isograsp::gui::BasisDialog</name>
    <message>
        <source>choose …</source>
        <translation>wählen …</translation>
    </message>
    <message>
        <source>%1 (arrow keys)</source>
        <translation>%1 (Pfeiltasten)</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Lawful basis</source>
        <translation>Rechtsgrundlage</translation>
    </message>
    <message>
        <source>No camera looks at a person before a lawful basis is on record. Of each purpose the last entry counts; treatment or research must be given.</source>
        <translation>Keine Kamera sieht einen Menschen, bevor eine Rechtsgrundlage eingetragen ist. Zu jedem Zweck zählt der letzte Eintrag; Behandlung oder Forschung muss erteilt sein.</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Zweck</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>Grundlage</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Eingetragen von</translation>
    </message>
    <message>
        <source>What is on record</source>
        <translation>Was eingetragen ist</translation>
    </message>
    <message>
        <source>In the order in which it was recorded</source>
        <translation>In der Reihenfolge, in der es eingetragen wurde</translation>
    </message>
    <message>
        <source>Nothing is on record.</source>
        <translation>Nichts ist eingetragen.</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Eintragen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>When it was said or signed; Up and Down change it (Tab)</source>
        <translation>Wann es gesagt oder unterschrieben wurde; Pfeil auf und ab ändern ihn (Tab)</translation>
    </message>
    <message>
        <source>such as the version of the form</source>
        <translation>etwa die Fassung des Formulars</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Such as the version of the form; may be left empty (Tab)</source>
        <translation>Etwa die Fassung des Formulars; kann leer bleiben (Tab)</translation>
    </message>
    <message>
        <source>Give the day on which it was said.</source>
        <translation>Geben Sie den Tag an, an dem es gesagt wurde.</translation>
    </message>
    <message>
        <source>Adds this entry under your name; it is not changed any more (Enter)</source>
        <translation>Fügt diesen Eintrag unter Ihrem Namen hinzu; er wird nicht mehr geändert (Eingabe)</translation>
    </message>
    <message>
        <source>Choose purpose, basis and answer first</source>
        <translation>Wählen Sie zuerst Zweck, Grundlage und Antwort</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BasisView</name>
    <message>
        <source>Lawful basis …</source>
        <translation>Rechtsgrundlage …</translation>
    </message>
    <message>
        <source>Lawful basis of this person</source>
        <translation>Rechtsgrundlage zu diesem Menschen</translation>
    </message>
    <message>
        <source>Shows what is on record, and records one more entry (Tab, then space)</source>
        <translation>Zeigt, was eingetragen ist, und trägt einen weiteren Eintrag ein (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Looking for a lawful basis …</source>
        <translation>Eine Rechtsgrundlage wird gesucht …</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>✗ No camera may look at this person: no lawful basis is on record.</source>
        <translation>✗ Keine Kamera darf diesen Menschen sehen: Es ist keine Rechtsgrundlage eingetragen.</translation>
    </message>
    <message>
        <source>No camera may look at this person:</source>
        <translation>Keine Kamera darf diesen Menschen sehen:</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BothHandsPanel</name>
    <message>
        <source>No share: the affected side is not on record.</source>
        <translation>Kein Anteil: die betroffene Seite ist nicht erfasst.</translation>
    </message>
    <message>
        <source>Shares are above rest: measure the resting forces first.</source>
        <translation>Anteile sind über der Ruhe: zuerst die Ruhekräfte messen.</translation>
    </message>
    <message>
        <source>Share: both hands rest.</source>
        <translation>Anteil: beide Hände ruhen.</translation>
    </message>
    <message>
        <source>Share of the affected hand (left) &lt;b&gt;%1 %&lt;/b&gt;</source>
        <translation>Anteil der betroffenen Hand (links) &lt;b&gt;%1 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Share of the affected hand (right) &lt;b&gt;%1 %&lt;/b&gt;</source>
        <translation>Anteil der betroffenen Hand (rechts) &lt;b&gt;%1 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 · of effort &lt;b&gt;%2 %&lt;/b&gt;</source>
        <translation>%1 · der Anstrengung &lt;b&gt;%2 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Live forces of both hands</source>
        <translation>Kräfte beider Hände jetzt</translation>
    </message>
    <message>
        <source>Grip: the smaller of the thumb and the two fingers together; above rest below it</source>
        <translation>Griff: der kleinere Wert von Daumen und beiden Fingern zusammen; darunter über der Ruhe</translation>
    </message>
    <message>
        <source>Mean of the last second above each hand&apos;s rest; of effort: each as a part of its maximum. It also rises when the other hand weakens: look at both forces</source>
        <translation>Mittel der letzten Sekunde über der Ruhe jeder Hand; der Anstrengung: jede als Teil ihres Maximums. Er steigt auch, wenn die andere Hand schwächer wird: beide Kräfte ansehen</translation>
    </message>
    <message>
        <source>Grip forces of the last 20 seconds</source>
        <translation>Griffkräfte der letzten 20 Sekunden</translation>
    </message>
    <message>
        <source>Left L, right R, both L+R, and what is asked of them dashed; the values stand above</source>
        <translation>Links L, rechts R, beide L+R, gestrichelt was verlangt ist; die Werte stehen darüber</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>%1, affected</source>
        <translation>%1, betroffen</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>above rest %1 N</source>
        <translation>über Ruhe %1 N</translation>
    </message>
    <message>
        <source>Left platform: %1</source>
        <translation>Linke Plattform: %1</translation>
    </message>
    <message>
        <source>Right platform: %1</source>
        <translation>Rechte Plattform: %1</translation>
    </message>
    <message>
        <source>Left %1</source>
        <comment>a finger</comment>
        <translation>Links: %1</translation>
    </message>
    <message>
        <source>Right %1</source>
        <comment>a finger</comment>
        <translation>Rechts: %1</translation>
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
        <source>lost %1, damaged %2</source>
        <translation>verloren %1, beschädigt %2</translation>
    </message>
    <message>
        <source>no forces yet</source>
        <translation>noch keine Kräfte</translation>
    </message>
    <message>
        <source>No share: the platforms move each other.</source>
        <translation>Kein Anteil: die Plattformen bewegen sich gegenseitig.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BothScreeningForm</name>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>✓ %1</source>
        <translation>✓ %1</translation>
    </message>
    <message>
        <source>%1: answered</source>
        <translation>%1: beantwortet</translation>
    </message>
    <message>
        <source>%1: to be asked</source>
        <translation>%1: noch zu fragen</translation>
    </message>
    <message>
        <source>The questions of this hand (Tab, then space)</source>
        <translation>Die Fragen zu dieser Hand (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>For both hands holds: %1.</source>
        <translation>Für beide Hände gilt: %1.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::CamerasDialog</name>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Qualisys Track Manager</source>
        <translation>Qualisys Track Manager</translation>
    </message>
    <message>
        <source>OptiTrack Motive</source>
        <translation>OptiTrack Motive</translation>
    </message>
    <message>
        <source>A recording of markers</source>
        <translation>Eine Aufzeichnung von Markern</translation>
    </message>
    <message>
        <source>System of the cameras</source>
        <translation>System der Kameras</translation>
    </message>
    <message>
        <source>Whose pictures are read (arrow keys)</source>
        <translation>Wessen Bilder gelesen werden (Pfeiltasten)</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose the recording</source>
        <translation>Die Aufzeichnung wählen</translation>
    </message>
    <message>
        <source>C3D, TRC, Qualisys table or CSV (Tab)</source>
        <translation>C3D, TRC, Qualisys-Tabelle oder CSV (Tab)</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Markersatz</translation>
    </message>
    <message>
        <source>What the markers are stuck to; docs/markers.md (arrow keys)</source>
        <translation>Woran die Marker kleben; docs/markers.md (Pfeiltasten)</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Use these cameras</source>
        <translation>Diese Kameras nehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open a recording of markers</source>
        <translation>Eine Aufzeichnung von Markern öffnen</translation>
    </message>
    <message>
        <source>Markers (*.c3d *.trc *.tsv *.csv);;All files (*)</source>
        <translation>Marker (*.c3d *.trc *.tsv *.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Datei der Aufzeichnung</translation>
    </message>
    <message>
        <source>Address of their computer</source>
        <translation>Adresse ihres Rechners</translation>
    </message>
    <message>
        <source>Where the recording is (Tab)</source>
        <translation>Wo die Aufzeichnung liegt (Tab)</translation>
    </message>
    <message>
        <source>Name or number in the network; with :PORT if it is another one (Tab)</source>
        <translation>Name oder Nummer im Netz; mit :PORT, wenn es ein anderer ist (Tab)</translation>
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
    <name>isograsp::gui::ChosenPerson</name>
    <message>
        <source>tasks one by one</source>
        <translation>Aufgaben einzeln</translation>
    </message>
    <message>
        <source>%1   %2, %3, %4</source>
        <translation>%1   %2, %3, %4</translation>
    </message>
    <message>
        <source>Choose a card to see how somebody is doing.</source>
        <translation>Wählen Sie eine Karte, um zu sehen, wie es jemandem geht.</translation>
    </message>
    <message>
        <source>No session yet.</source>
        <translation>Noch keine Sitzung.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ClosingPanel</name>
    <message>
        <source>Effort and pain: not asked yet.</source>
        <translation>Anstrengung und Schmerz: noch nicht gefragt.</translation>
    </message>
    <message>
        <source>Effort %1 of 10, pain %2 of 10.</source>
        <translation>Anstrengung %1 von 10, Schmerz %2 von 10.</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Last time</source>
        <translation>Letztes Mal</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Today against last time</source>
        <translation>Heute und letztes Mal</translation>
    </message>
    <message>
        <source>Means of today&apos;s trials and of the session before; a verdict of change for the primary measures (Tab, arrow keys)</source>
        <translation>Mittelwerte der Versuche von heute und der Sitzung davor; für die Hauptmaße ein Urteil über die Veränderung (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>Print for the patient …</source>
        <translation>Für den Patienten drucken …</translation>
    </message>
    <message>
        <source>The page in large letters that the patient takes home (Tab, then Enter)</source>
        <translation>Die Seite in großer Schrift zum Mitnehmen (Tab, dann Eingabetaste)</translation>
    </message>
    <message>
        <source>Report …</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>All of this patient&apos;s report, on its page (Ctrl+R)</source>
        <translation>Der ganze Bericht über diesen Patienten, auf seiner Seite (Strg+R)</translation>
    </message>
    <message>
        <source>End and next patient</source>
        <translation>Beenden, nächster Patient</translation>
    </message>
    <message>
        <source>Ends the session and shows who comes today (F8)</source>
        <translation>Beendet die Sitzung und zeigt, wer heute kommt (F8)</translation>
    </message>
    <message>
        <source>The page for the patient was sent to the printer.</source>
        <translation>Die Seite zum Mitnehmen ging an den Drucker.</translation>
    </message>
    <message>
        <source>The printer takes nothing: is it connected, has it paper?</source>
        <translation>Der Drucker nimmt nichts an: Ist er angeschlossen, hat er Papier?</translation>
    </message>
    <message>
        <source>Today: %1, %2</source>
        <translation>Heute: %1, %2</translation>
    </message>
    <message>
        <source>Looking at what is stored …</source>
        <translation>Gespeichertes wird gelesen …</translation>
    </message>
    <message>
        <source>first time</source>
        <translation>zum ersten Mal</translation>
    </message>
    <message>
        <source>Valid: nothing that was recorded speaks against today&apos;s values.</source>
        <translation>Gültig: Nichts von dem, was aufgezeichnet wurde, spricht gegen die Werte von heute.</translation>
    </message>
    <message>
        <source>To be kept in mind. %1</source>
        <translation>Zu bedenken. %1</translation>
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
        <source>Device or cameras</source>
        <translation>Gerät oder Kameras</translation>
    </message>
    <message>
        <source>Do not connect (Alt+C)</source>
        <translation>Nicht verbinden (Alt+C)</translation>
    </message>
    <message>
        <source>Begin the session, once the steps above are done (Alt+C)</source>
        <translation>Die Sitzung beginnen, sobald die Schritte darüber getan sind (Alt+C)</translation>
    </message>
    <message>
        <source>Forget this device</source>
        <translation>Dieses Gerät vergessen</translation>
    </message>
    <message>
        <source>Takes what was added here out of the list (Tab, then space)</source>
        <translation>Nimmt aus der Liste, was hier hinzugefügt wurde (Tab, dann Leertaste)</translation>
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
    <name>isograsp::gui::CrossTalkForm</name>
    <message>
        <source>Press the left platform with at least 20 N for half a second.</source>
        <translation>Die linke Plattform eine halbe Sekunde mit mindestens 20 N drücken.</translation>
    </message>
    <message>
        <source>Now press the right platform with at least 20 N.</source>
        <translation>Jetzt die rechte Plattform mit mindestens 20 N drücken.</translation>
    </message>
    <message>
        <source>Skipped; this is stored with the session.</source>
        <translation>Ausgelassen; das wird mit der Sitzung gespeichert.</translation>
    </message>
    <message>
        <source>Do the platforms move each other? Both empty, press one, then the other.</source>
        <translation>Bewegen sich die Plattformen gegenseitig? Beide leer: eine drücken, dann die andere.</translation>
    </message>
    <message>
        <source>They move each other by %1 %: mount them apart. This session has no shares.</source>
        <translation>Sie bewegen sich gegenseitig um %1 %: getrennt aufstellen. Diese Sitzung hat keine Anteile.</translation>
    </message>
    <message>
        <source>✓ They stand apart: %1 % at most.</source>
        <translation>✓ Sie stehen getrennt: höchstens %1 %.</translation>
    </message>
    <message>
        <source>Skip this check</source>
        <translation>Diese Prüfung auslassen</translation>
    </message>
    <message>
        <source>Nobody knows then whether one platform moves the other; stored with the session (Tab, then space)</source>
        <translation>Dann weiß niemand, ob eine Plattform die andere bewegt; wird mit der Sitzung gespeichert (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Prüfung beenden</translation>
    </message>
    <message>
        <source>Check the platforms again</source>
        <translation>Plattformen noch einmal prüfen</translation>
    </message>
    <message>
        <source>Check the platforms</source>
        <translation>Plattformen prüfen</translation>
    </message>
    <message>
        <source>Each is pressed, empty, with 20 N; the other one may feel 1 % of it (Tab, then space)</source>
        <translation>Jede wird leer mit 20 N gedrückt; die andere darf 1 % davon spüren (Tab, dann Leertaste)</translation>
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
    <message>
        <source>Pictures of the cameras: %1
Lost: %2
Twice: %3
With other markers: %4
Damaged: %5
Connected again: %6</source>
        <translation>Bilder der Kameras: %1
Verloren: %2
Doppelt: %3
Mit anderen Markern: %4
Beschädigt: %5
Neu verbunden: %6</translation>
    </message>
    <message>
        <source>What the cameras counted</source>
        <translation>Was die Kameras gezählt haben</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>A device, or cameras, are chosen and connected on the page of the session, once patient and hand are known.</source>
        <translation>Ein Gerät oder Kameras werden auf der Seite der Sitzung gewählt und verbunden, sobald Patient und Hand bekannt sind.</translation>
    </message>
    <message>
        <source>Nothing is connected.</source>
        <translation>Nichts ist verbunden.</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Handverfolgung</translation>
    </message>
    <message>
        <source>What the tracker counted</source>
        <translation>Was die Handverfolgung zählte</translation>
    </message>
    <message>
        <source>Pictures of the tracker: %1
Rows of this hand: %2
Not seen: %3
Of the other hand, not used: %4
Lost: %5
Damaged: %6
Connected again: %7</source>
        <translation>Bilder der Handverfolgung: %1
Zeilen dieser Hand: %2
Nicht gesehen: %3
Von der anderen Hand, nicht verwendet: %4
Verloren: %5
Beschädigt: %6
Neu verbunden: %7</translation>
    </message>
    <message>
        <source>Platform of the left hand</source>
        <translation>Plattform der linken Hand</translation>
    </message>
    <message>
        <source>Platform of the right hand</source>
        <translation>Plattform der rechten Hand</translation>
    </message>
    <message>
        <source>Platform to be checked</source>
        <translation>Plattform, die geprüft wird</translation>
    </message>
    <message>
        <source>Which of the two platforms (Tab, arrow keys)</source>
        <translation>Welche der beiden Plattformen (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>Both platforms</source>
        <translation>Beide Plattformen</translation>
    </message>
    <message>
        <source>left platform, %1</source>
        <translation>linke Plattform, %1</translation>
    </message>
    <message>
        <source>right platform, %1</source>
        <translation>rechte Plattform, %1</translation>
    </message>
    <message>
        <source>What the sensors counted, left / right</source>
        <translation>Was die Sensoren gezählt haben, links / rechts</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <comment>samples of the left and of the right platform</comment>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::EntryForm</name>
    <message>
        <source>At rest: the hand lies still for ten seconds.</source>
        <translation>In Ruhe: Die Hand liegt zehn Sekunden still.</translation>
    </message>
    <message>
        <source>Now open wide.</source>
        <translation>Jetzt weit öffnen.</translation>
    </message>
    <message>
        <source>Now close.</source>
        <translation>Jetzt schließen.</translation>
    </message>
    <message>
        <source>%1 Opened %2 of %3 times.</source>
        <translation>%1 %2 von %3 Mal geöffnet.</translation>
    </message>
    <message>
        <source>Opens %1 mm: objects up to %2 mm are offered.</source>
        <translation>Öffnet %1 mm: Objekte bis %2 mm werden angeboten.</translation>
    </message>
    <message>
        <source>Entry test</source>
        <translation>Eingangstest</translation>
    </message>
    <message>
        <source>Entry test: ten seconds at rest, then three openings</source>
        <translation>Eingangstest: zehn Sekunden Ruhe, dann drei Öffnungen</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Begin the entry test</source>
        <translation>Eingangstest beginnen</translation>
    </message>
    <message>
        <source>Ten seconds at rest, then open and close three times: says whether virtual objects are for this hand, and how wide ones (Tab, then space)</source>
        <translation>Zehn Sekunden Ruhe, dann dreimal öffnen und schließen: Sagt, ob virtuelle Objekte für diese Hand sind, und wie breite (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>The hand is not seen: bring it before the tracker.</source>
        <translation>Die Hand ist nicht zu sehen: vor die Kamera bringen.</translation>
    </message>
    <message>
        <source>The hand is seen.</source>
        <translation>Die Hand ist zu sehen.</translation>
    </message>
    <message>
        <source>Ten seconds at rest on the table, then open and close three times.</source>
        <translation>Zehn Sekunden Ruhe auf dem Tisch, dann dreimal öffnen und schließen.</translation>
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
    <name>isograsp::gui::FaultCard</name>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>What has failed (F8)</source>
        <translation>Was nicht gelungen ist (F8)</translation>
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
    <name>isograsp::gui::FirstVisitOffer</name>
    <message>
        <source>Begin as a first &amp;visit</source>
        <translation>Erstbesuch &amp;vorziehen</translation>
    </message>
    <message>
        <source>Choose the protocol of a first visit</source>
        <translation>Das Protokoll eines ersten Besuchs wählen</translation>
    </message>
    <message>
        <source>It begins with practice in bouts (Alt+V)</source>
        <translation>Es beginnt mit Übung in Abschnitten (Alt+V)</translation>
    </message>
    <message>
        <source>This arm has not worked with the cameras before. “%1” begins with %2 minutes of practice.</source>
        <translation>Dieser Arm hat noch nie mit den Kameras gearbeitet. „%1“ beginnt mit %2 Minuten Übung.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::GraspView</name>
    <message>
        <source>Hold, weakest direction (G min)</source>
        <translation>Halt, schwächste Richtung (G min)</translation>
    </message>
    <message>
        <source>Hand, weakest direction (H min)</source>
        <translation>Hand, schwächste Richtung (H min)</translation>
    </message>
    <message>
        <source>Hand, on the whole (H det)</source>
        <translation>Hand, insgesamt (H det)</translation>
    </message>
    <message>
        <source>%1: pull</source>
        <translation>%1: Zug</translation>
    </message>
    <message>
        <source>%1: how hard it pulls away, as a share of the pull at which its tie lets go</source>
        <translation>%1: wie stark er wegzieht, als Anteil des Zugs, bei dem die Verbindung loslässt</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 of %2 N</source>
        <translation>%1 von %2 N</translation>
    </message>
    <message>
        <source>Grasp: no object is there.</source>
        <translation>Griff: Es ist kein Objekt da.</translation>
    </message>
    <message>
        <source>Grasp: fewer than two fingers touch.</source>
        <translation>Griff: weniger als zwei Finger berühren.</translation>
    </message>
    <message>
        <source>Grasp: ✓ it holds, and may be helped.</source>
        <translation>Griff: ✓ er hält und darf Hilfe haben.</translation>
    </message>
    <message>
        <source>Grasp: ✗ only the help holds it.</source>
        <translation>Griff: ✗ nur die Hilfe hält ihn.</translation>
    </message>
    <message>
        <source>Grasp: ✗ it does not hold yet.</source>
        <translation>Griff: ✗ er hält noch nicht.</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HandPanel</name>
    <message>
        <source>Counting the pictures of the tracker …</source>
        <translation>Bilder der Handverfolgung werden gezählt …</translation>
    </message>
    <message>
        <source>Live hand</source>
        <translation>Hand, jetzt</translation>
    </message>
    <message>
        <source>Let the object go</source>
        <translation>Objekt loslassen</translation>
    </message>
    <message>
        <source>The object falls through the hand; the placement ends as helped, which is no drop (Ctrl+O)</source>
        <translation>Das Objekt fällt durch die Hand; das Ablegen endet mit Hilfe, das ist kein Fallenlassen (Strg+O)</translation>
    </message>
    <message>
        <source>● Camera on</source>
        <translation>● Kamera an</translation>
    </message>
    <message>
        <source>A camera looks at the person until the session ends. No picture is read or stored</source>
        <translation>Eine Kamera sieht die Person, bis die Sitzung endet. Kein Bild wird gelesen oder gespeichert</translation>
    </message>
    <message>
        <source>The hand is shown once the tracker is connected.</source>
        <translation>Die Hand erscheint, sobald die Handverfolgung verbunden ist.</translation>
    </message>
    <message>
        <source>The hand is not seen.</source>
        <translation>Die Hand ist nicht zu sehen.</translation>
    </message>
    <message>
        <source>Thumb and index %1 mm apart.</source>
        <translation>Daumen und Zeigefinger %1 mm auseinander.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2&lt;/b&gt; done</source>
        <translation>&lt;b&gt;%1 von %2&lt;/b&gt; gemacht</translation>
    </message>
    <message>
        <source>No trial is running.</source>
        <translation>Es läuft kein Versuch.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2&lt;/b&gt; placed · placement %3 · help: &lt;b&gt;%4&lt;/b&gt; · drops &lt;b&gt;%5&lt;/b&gt;</source>
        <translation>&lt;b&gt;%1 von %2&lt;/b&gt; abgelegt · Ablegen %3 · Hilfe: &lt;b&gt;%4&lt;/b&gt; · &lt;b&gt;%5&lt;/b&gt; gefallen</translation>
    </message>
    <message>
        <source>%1 · eased</source>
        <translation>%1 · erleichtert</translation>
    </message>
    <message>
        <source>%1 · &lt;b&gt;let go for the hand&lt;/b&gt;</source>
        <translation>%1 · &lt;b&gt;für die Hand losgelassen&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 · &lt;b&gt;the hand is to open&lt;/b&gt;</source>
        <translation>%1 · &lt;b&gt;die Hand soll sich öffnen&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 Virtual hand %2 mm from the tracked one.</source>
        <translation>%1 Virtuelle Hand %2 mm neben der verfolgten.</translation>
    </message>
    <message>
        <source>%1 pictures a second · %2 % of the last 10 s not seen · times lost: %3</source>
        <translation>%1 Bilder je Sekunde · %2 % der letzten 10 s nicht gesehen · Mal verloren: %3</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HandScreeningForm</name>
    <message>
        <source>Nothing applies, no pain: the hand may move</source>
        <translation>Nichts trifft zu, kein Schmerz: Die Hand darf sich bewegen</translation>
    </message>
    <message>
        <source>None of the reasons below, no pain, forearm as ticked (Alt+P)</source>
        <translation>Keiner der Gründe unten, kein Schmerz, Unterarm wie angekreuzt (Alt+Z)</translation>
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
        <source>Forearm supported</source>
        <translation>Unterarm gestützt</translation>
    </message>
    <message>
        <source>It lies on the table or a rest while the hand works; stored with the session (Tab, then space)</source>
        <translation>Er liegt auf dem Tisch oder einer Auflage, während die Hand arbeitet; wird mit der Sitzung gespeichert (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>You decide for this hand</source>
        <translation>Sie entscheiden für diese Hand</translation>
    </message>
    <message>
        <source>%1: this hand, today (Tab, then space)</source>
        <translation>%1: diese Hand, heute (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>It may move</source>
        <translation>Sie darf sich bewegen</translation>
    </message>
    <message>
        <source>No movement</source>
        <translation>Keine Bewegung</translation>
    </message>
    <message>
        <source>Nothing applies, no &amp;pain</source>
        <translation>Nichts trifft &amp;zu, kein Schmerz</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HandsPlot</name>
    <message>
        <source>Time before now (s)</source>
        <translation>Zeit vor jetzt (s)</translation>
    </message>
    <message>
        <source>Grip force (N)</source>
        <translation>Griffkraft (N)</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left hand, at the end of its curve</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right hand, at the end of its curve</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>L+R</source>
        <comment>both hands, at the end of their curve</comment>
        <translation>L+R</translation>
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
    <message>
        <source>P&amp;ostures</source>
        <translation>&amp;Haltungen</translation>
    </message>
    <message>
        <source>Postures</source>
        <translation>Haltungen</translation>
    </message>
    <message>
        <source>What an arm is asked to do with an object (Alt+O)</source>
        <translation>Wohin ein Arm einen Gegenstand bringen soll (Alt+H)</translation>
    </message>
    <message>
        <source>Saved. Trials were recorded with the former postures, which are kept as %1: with these a new series begins.</source>
        <translation>Gespeichert. Mit den bisherigen Haltungen wurden Versuche aufgenommen, sie bleiben als %1 erhalten: Mit diesen beginnt eine neue Reihe.</translation>
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
    <name>isograsp::gui::MarkerTable</name>
    <message>
        <source>Marker</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Segments and markers</source>
        <translation>Segmente und Marker</translation>
    </message>
    <message>
        <source>How much of the last 10 seconds each was seen, by how much its markers miss it, and what the newest picture shows (Tab, then arrow keys)</source>
        <translation>Wie viel der letzten 10 Sekunden jedes gesehen wurde, um wie viel seine Marker es verfehlen und was das neueste Bild zeigt (Tab, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::NextBar</name>
    <message>
        <source>Choose a patient</source>
        <translation>Patient wählen</translation>
    </message>
    <message>
        <source>Choose the arm</source>
        <translation>Arm wählen</translation>
    </message>
    <message>
        <source>Choose the hand</source>
        <translation>Hand wählen</translation>
    </message>
    <message>
        <source>Answer the screening</source>
        <translation>Sicherheitsfragen beantworten</translation>
    </message>
    <message>
        <source>Go on or anew?</source>
        <translation>Weiter oder neu?</translation>
    </message>
    <message>
        <source>Choose the device</source>
        <translation>Gerät wählen</translation>
    </message>
    <message>
        <source>The state of the session and the sensible next step</source>
        <translation>Der Stand der Sitzung und der sinnvolle nächste Schritt</translation>
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
        <source>The next thing to do (F8)</source>
        <translation>Das Nächste, was zu tun ist (F8)</translation>
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
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>x to the right, y up; arrows: fingers or hands, and where they press; outlines: targets in their order, dashed: where an object appears</source>
        <translation>x nach rechts, y nach oben; Pfeile: Finger oder Hände und wo sie drücken; Umrisse: Ziele in ihrer Reihenfolge, gestrichelt: wo ein Objekt erscheint</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::OpenSessionStrip</name>
    <message>
        <source>&amp;Go to it</source>
        <translation>Da&amp;hin gehen</translation>
    </message>
    <message>
        <source>Go to the open session</source>
        <translation>Zur offenen Sitzung gehen</translation>
    </message>
    <message>
        <source>Alt+G</source>
        <translation>Alt+H</translation>
    </message>
    <message>
        <source>&amp;End it</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>End the open session</source>
        <translation>Die offene Sitzung beenden</translation>
    </message>
    <message>
        <source>All that was measured is kept; a trial that stands still is ended and marked (Alt+E)</source>
        <translation>Alles Gemessene bleibt; ein Versuch, der stillsteht, wird beendet und gekennzeichnet (Alt+B)</translation>
    </message>
    <message>
        <source>The session of %1, %2, is open since %3.</source>
        <translation>Die Sitzung von %1, %2, ist seit %3 offen.</translation>
    </message>
    <message>
        <source>%1 A trial runs.</source>
        <translation>%1 Ein Versuch läuft.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::OtherHandButton</name>
    <message>
        <source>Now the left arm</source>
        <translation>Jetzt der linke Arm</translation>
    </message>
    <message>
        <source>Now the right arm</source>
        <translation>Jetzt der rechte Arm</translation>
    </message>
    <message>
        <source>Now the left hand</source>
        <translation>Jetzt die linke Hand</translation>
    </message>
    <message>
        <source>Now the right hand</source>
        <translation>Jetzt die rechte Hand</translation>
    </message>
    <message>
        <source>What was done is kept; screening, zero and straps are asked anew, the device stays chosen (Tab, then space)</source>
        <translation>Was getan ist, bleibt erhalten; Sicherheitsfragen, Nullabgleich und Gurte werden neu erfragt, das Gerät bleibt gewählt (Tab, dann Leertaste)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatchSketch</name>
    <message>
        <source>What the pads cover of the object: %1</source>
        <translation>Was die Kuppen vom Objekt bedecken: %1</translation>
    </message>
    <message>
        <source>Each as the pad looks at the object, tangent up; dashed: the whole pad; filled: what it covers; cross: the middle of that; red: where a ray ends before the pad does</source>
        <translation>Jede, wie sie auf das Objekt blickt, Tangente nach oben; gestrichelt: die ganze Kuppe; gefüllt: was sie bedeckt; Kreuz: dessen Mitte; rot: wo ein Strahl vor der Kuppe endet</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>friction ends</source>
        <translation>Reibung endet</translation>
    </message>
    <message>
        <source>surface ends</source>
        <translation>Fläche endet</translation>
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
    <name>isograsp::gui::PictureCheckView</name>
    <message>
        <source>The hand is moved to the right, up and away, towards the screen; the picture must do the same. Before the first object (Tab, then space)</source>
        <translation>Die Hand bewegt sich nach rechts, nach oben und weg, zum Bildschirm hin; das Bild muss dasselbe tun. Vor dem ersten Gegenstand (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>The hand moves 10 cm to the right, and rests.</source>
        <translation>Die Hand bewegt sich 10 cm nach rechts und ruht.</translation>
    </message>
    <message>
        <source>It moves 10 cm up, and rests.</source>
        <translation>Sie bewegt sich 10 cm nach oben und ruht.</translation>
    </message>
    <message>
        <source>It moves 10 cm away, towards the screen, and rests.</source>
        <translation>Sie bewegt sich 10 cm weg, zum Bildschirm hin, und ruht.</translation>
    </message>
    <message>
        <source>The hand is held still where the tracker sees it.</source>
        <translation>Die Hand bleibt ruhig, wo die Handverfolgung sie sieht.</translation>
    </message>
    <message>
        <source>✓ The picture moves as the hand does.</source>
        <translation>✓ Das Bild bewegt sich wie die Hand.</translation>
    </message>
    <message>
        <source>✗ In the picture it went %1° off. Once more; if it stays so, the tracker stands another way than its program says: no object comes.</source>
        <translation>✗ Im Bild ging sie %1° daneben. Noch einmal; bleibt es so, steht die Handverfolgung anders, als ihr Programm sagt: Es kommt kein Gegenstand.</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Prüfung beenden</translation>
    </message>
    <message>
        <source>Check the picture</source>
        <translation>Bild prüfen</translation>
    </message>
    <message>
        <source>You move the object to the right, up and away, towards the screen; the picture must do the same. Before the first trial (Tab, then space)</source>
        <translation>Sie bewegen den Gegenstand nach rechts, nach oben und von sich weg zum Bildschirm; das Bild muss dasselbe tun. Vor dem ersten Versuch (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Move the object 10 cm to the right, seen by the patient, and rest.</source>
        <translation>Den Gegenstand 10 cm nach rechts, vom Patienten aus, dann ruhen.</translation>
    </message>
    <message>
        <source>Move it 10 cm up, and rest.</source>
        <translation>10 cm nach oben, dann ruhen.</translation>
    </message>
    <message>
        <source>Move it 10 cm away, towards the screen, and rest.</source>
        <translation>10 cm weg, zum Bildschirm hin, dann ruhen.</translation>
    </message>
    <message>
        <source>Hold the object still where the cameras see it.</source>
        <translation>Den Gegenstand stillhalten, wo die Kameras ihn sehen.</translation>
    </message>
    <message>
        <source>✓ The picture moves as the object does.</source>
        <translation>✓ Das Bild bewegt sich wie der Gegenstand.</translation>
    </message>
    <message>
        <source>✗ In the picture it went %1° off. Once more; if it stays so, [view] of the rig names other axes: nothing begins that is done by this picture.</source>
        <translation>✗ Im Bild ging er %1° daneben. Noch einmal; bleibt es so, nennt [view] des Markersatzes andere Achsen: Nach diesem Bild beginnt kein Versuch.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PlatformsForm</name>
    <message>
        <source>Platform of the left hand</source>
        <translation>Plattform der linken Hand</translation>
    </message>
    <message>
        <source>Platform of the right hand</source>
        <translation>Plattform der rechten Hand</translation>
    </message>
    <message>
        <source>What is present now, and a simulated person (Tab, then arrow keys)</source>
        <translation>Was jetzt da ist, und eine simulierte Person (Tab, dann Pfeiltasten)</translation>
    </message>
    <message>
        <source>Left platform</source>
        <translation>Linke Plattform</translation>
    </message>
    <message>
        <source>Right platform</source>
        <translation>Rechte Plattform</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureDesk</name>
    <message>
        <source>Not recorded: the arm moved by %1 mm (SD). Hold it still.</source>
        <translation>Nicht aufgenommen: Der Arm hat sich um %1 mm bewegt (SD). Ihn stillhalten.</translation>
    </message>
    <message>
        <source>Not recorded: elbow, forearm, hand and object were not seen together for a second.</source>
        <translation>Nicht aufgenommen: Ellbogen, Unterarm, Hand und Gegenstand wurden nicht eine Sekunde zusammen gesehen.</translation>
    </message>
    <message>
        <source>Recorded for a second; it moved by %1 mm (SD).</source>
        <translation>Eine Sekunde aufgenommen; er hat sich um %1 mm bewegt (SD).</translation>
    </message>
    <message>
        <source>Recorded postures</source>
        <translation>Aufgenommene Haltungen</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureEditor</name>
    <message>
        <source>Changed postures are another series: what is measured with them is not compared with what was measured before.</source>
        <translation>Geänderte Haltungen sind eine andere Reihe: Was mit ihnen gemessen wird, wird nicht mit früher Gemessenem verglichen.</translation>
    </message>
    <message>
        <source>Name of the file</source>
        <translation>Name der Datei</translation>
    </message>
    <message>
        <source>For people; Enter takes it (Tab)</source>
        <translation>Für Menschen; Eingabe übernimmt ihn (Tab)</translation>
    </message>
    <message>
        <source>Postures of the file</source>
        <translation>Haltungen der Datei</translation>
    </message>
    <message>
        <source>Arrow keys choose one; X, Y and Z turn its link, with Shift the other way; Ctrl with arrow and page keys moves it</source>
        <translation>Pfeiltasten wählen eine; X, Y und Z drehen ihr Glied, mit Umschalt andersherum; Strg mit Pfeil- und Bildtasten verschiebt es</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopie</translation>
    </message>
    <message>
        <source>Copy the posture</source>
        <translation>Haltung kopieren</translation>
    </message>
    <message>
        <source>The same posture once more (Tab, then space)</source>
        <translation>Dieselbe Haltung noch einmal (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the posture</source>
        <translation>Haltung löschen</translation>
    </message>
    <message>
        <source>Takes it out of the file; Undo brings it back (Delete)</source>
        <translation>Nimmt sie aus der Datei; Rückgängig holt sie zurück (Entf)</translation>
    </message>
    <message>
        <source>Name of the posture</source>
        <translation>Name der Haltung</translation>
    </message>
    <message>
        <source>Tasks call it by that; Enter takes it (Tab)</source>
        <translation>So nennen Aufgaben sie; Eingabe übernimmt ihn (Tab)</translation>
    </message>
    <message>
        <source>Posture</source>
        <translation>Haltung</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>What turns</source>
        <translation>Was sich dreht</translation>
    </message>
    <message>
        <source>What lies beyond it goes along (arrow keys)</source>
        <translation>Was dahinter liegt, geht mit (Pfeiltasten)</translation>
    </message>
    <message>
        <source>About whose axes</source>
        <translation>Um wessen Achsen</translation>
    </message>
    <message>
        <source>They are drawn in the picture, at the origin about which is turned (arrow keys)</source>
        <translation>Sie sind im Bild gezeichnet, an dem Punkt, um den gedreht wird (Pfeiltasten)</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>axes of</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn by, in degrees</source>
        <translation>Drehen um, in Grad</translation>
    </message>
    <message>
        <source>One step of a turn (arrow keys)</source>
        <translation>Ein Schritt einer Drehung (Pfeiltasten)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Move by, in millimetres</source>
        <translation>Schieben um, in Millimetern</translation>
    </message>
    <message>
        <source>One step of a move (arrow keys)</source>
        <translation>Ein Schritt einer Verschiebung (Pfeiltasten)</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Schieben um</translation>
    </message>
    <message>
        <source>Turn about %1, %2</source>
        <translation>Um %1 drehen, %2</translation>
    </message>
    <message>
        <source>Move along %1, %2</source>
        <translation>Entlang %1 schieben, %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Part of the way from the initial posture, in per cent</source>
        <translation>Teil des Weges von der Anfangshaltung, in Prozent</translation>
    </message>
    <message>
        <source>0 is the initial posture, 100 this one (arrow keys)</source>
        <translation>0 ist die Anfangshaltung, 100 diese (Pfeiltasten)</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neue</translation>
    </message>
    <message>
        <source>A new posture so far on the way</source>
        <translation>Eine neue Haltung so weit auf dem Weg</translation>
    </message>
    <message>
        <source>Adds a posture so far on the way to this one; this one stays (Tab, then space)</source>
        <translation>Fügt eine Haltung so weit auf dem Weg zu dieser hinzu; diese bleibt (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Shorten</source>
        <translation>Kürzen</translation>
    </message>
    <message>
        <source>Shorten this posture to so much of its way</source>
        <translation>Diese Haltung auf so viel ihres Weges kürzen</translation>
    </message>
    <message>
        <source>Takes this posture back to so much of its way (Tab, then space)</source>
        <translation>Nimmt diese Haltung auf so viel ihres Weges zurück (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Way from the initial one</source>
        <translation>Weg vom Anfang</translation>
    </message>
    <message>
        <source>Recording the arm</source>
        <translation>Der Arm wird aufgenommen</translation>
    </message>
    <message>
        <source>The arm is held still for a second</source>
        <translation>Der Arm wird eine Sekunde stillgehalten</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufnahme abbrechen</translation>
    </message>
    <message>
        <source>Record the arm: next posture</source>
        <translation>Arm aufnehmen: nächste Haltung</translation>
    </message>
    <message>
        <source>Record the arm: new file</source>
        <translation>Arm aufnehmen: neue Datei</translation>
    </message>
    <message>
        <source>The arm is held still for a second, as guided; the same markers as in this file (Tab, then space)</source>
        <translation>Der Arm wird eine Sekunde stillgehalten, wie geführt; dieselben Marker wie in dieser Datei (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>The arm is held still for a second and becomes the initial posture of a new file: postures of one arm with other markers do not fit together (Tab, then space)</source>
        <translation>Der Arm wird eine Sekunde stillgehalten und wird die Anfangshaltung einer neuen Datei: Haltungen mit anders geklebten Markern passen nicht zusammen (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>%1 – all others are seen from it</source>
        <translation>%1 – von ihr aus sind alle anderen gesehen</translation>
    </message>
    <message>
        <source>The initial posture: the arm is held so before the work.</source>
        <translation>Die Anfangshaltung: So wird der Arm vor der Arbeit gehalten.</translation>
    </message>
    <message>
        <source>%1 %2°, %3 mm</source>
        <translation>%1 %2°, %3 mm</translation>
    </message>
    <message>
        <source>From the initial posture: %1</source>
        <translation>Von der Anfangshaltung: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureFields</name>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Posture and straps of this hand (Tab, then space)</source>
        <translation>Haltung und Gurte dieser Hand (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>%1, left hand</source>
        <translation>%1, linke Hand</translation>
    </message>
    <message>
        <source>%1, right hand</source>
        <translation>%1, rechte Hand</translation>
    </message>
    <message>
        <source>%1: the marks as written on them (Tab)</source>
        <translation>%1: die Marken, wie sie darauf stehen (Tab)</translation>
    </message>
    <message>
        <source>%1 (Tab, then arrow keys)</source>
        <translation>%1 (Tab, dann Pfeiltasten)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureForm</name>
    <message>
        <source>Not in sight: %1</source>
        <translation>Nicht zu sehen: %1</translation>
    </message>
    <message>
        <source>In sight. Hold the arm still.</source>
        <translation>Zu sehen. Den Arm stillhalten.</translation>
    </message>
    <message>
        <source>In sight and still: measure it now.</source>
        <translation>Zu sehen und still: jetzt messen.</translation>
    </message>
    <message>
        <source>Measure the start posture</source>
        <translation>Ausgangshaltung messen</translation>
    </message>
    <message>
        <source>Measuring the start posture</source>
        <translation>Die Ausgangshaltung wird gemessen</translation>
    </message>
    <message>
        <source>The arm is looked for once the cameras are connected.</source>
        <translation>Der Arm wird gesucht, sobald die Kameras verbunden sind.</translation>
    </message>
    <message>
        <source>The arm is held still for a second; targets are made for its size (Tab, then space)</source>
        <translation>Der Arm wird eine Sekunde stillgehalten; Ziele werden für seine Größe gemacht (Tab, dann Leertaste)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureView</name>
    <message>
        <source>The posture</source>
        <translation>Die Haltung</translation>
    </message>
    <message>
        <source>The arm in this posture from the front, from the side and from above</source>
        <translation>Der Arm in dieser Haltung von vorn, von der Seite und von oben</translation>
    </message>
    <message>
        <source>X, Y and Z turn the link, with Shift the other way; Ctrl with arrow and page keys moves it; one square is 10 cm</source>
        <translation>X, Y und Z drehen das Glied, mit Umschalt andersherum; Strg mit Pfeil- und Bildtasten verschiebt es; ein Quadrat ist 10 cm</translation>
    </message>
    <message>
        <source>The arm, and dashed the object in the initial posture</source>
        <translation>Der Arm, und gestrichelt der Gegenstand in der Anfangshaltung</translation>
    </message>
    <message>
        <source>The patient sees the object at the start, and this target.</source>
        <translation>Der Patient sieht den Gegenstand am Anfang und dieses Ziel.</translation>
    </message>
    <message>
        <source>Drawn flat: this display has no OpenGL for the 3D picture.</source>
        <translation>Flach gezeichnet: Diese Anzeige hat kein OpenGL für das 3D-Bild.</translation>
    </message>
    <message>
        <source>The object in three dimensions</source>
        <translation>Der Gegenstand in drei Dimensionen</translation>
    </message>
    <message>
        <source>As the patient sees it; the keys are those of the three sides</source>
        <translation>Wie ihn der Patient sieht; die Tasten sind die der drei Seiten</translation>
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
        <translation>Sicherheitsfragen</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Zero, empty</source>
        <translation>Nullabgleich (ohne Hand)</translation>
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
        <source>Alt+L</source>
        <translation>Alt+L</translation>
    </message>
    <message>
        <source>&amp;Right hand</source>
        <translation>&amp;Rechte Hand</translation>
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
    <message>
        <source>Start posture</source>
        <translation>Ausgangshaltung</translation>
    </message>
    <message>
        <source>Arm today</source>
        <translation>Arm heute</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Device or cameras</source>
        <translation>Gerät oder Kameras</translation>
    </message>
    <message>
        <source>Zero or start posture</source>
        <translation>Nullpunkt oder Ausgangshaltung</translation>
    </message>
    <message>
        <source>&amp;Left arm</source>
        <translation>&amp;Linker Arm</translation>
    </message>
    <message>
        <source>&amp;Right arm</source>
        <translation>&amp;Rechter Arm</translation>
    </message>
    <message>
        <source>Yes, the less affected arm</source>
        <translation>Ja, der weniger betroffene Arm</translation>
    </message>
    <message>
        <source>The affected side is the other one; this one is meant (Tab, then space)</source>
        <translation>Betroffen ist die andere Seite; diese ist gemeint (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Handverfolgung</translation>
    </message>
    <message>
        <source>Entry test</source>
        <translation>Eingangstest</translation>
    </message>
    <message>
        <source>opens %1 mm</source>
        <translation>öffnet %1 mm</translation>
    </message>
    <message>
        <source>Hands today</source>
        <translation>Hände heute</translation>
    </message>
    <message>
        <source>Platforms</source>
        <translation>Plattformen</translation>
    </message>
    <message>
        <source>Zeros, both empty</source>
        <translation>Nullabgleich (ohne Hände)</translation>
    </message>
    <message>
        <source>Hands in</source>
        <translation>Hände im Gerät</translation>
    </message>
    <message>
        <source>Both, on two platforms</source>
        <translation>Beide, auf zwei Plattformen</translation>
    </message>
    <message>
        <source>Both hands, on two platforms</source>
        <translation>Beide Hände, auf zwei Plattformen</translation>
    </message>
    <message>
        <source>Each hand on a platform of its own: asked in every session (Tab, then space)</source>
        <translation>Jede Hand auf ihrer eigenen Plattform: wird in jeder Sitzung gefragt (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>Protokoll: %1</translation>
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
    <name>isograsp::gui::QuestionsPanel</name>
    <message>
        <source>About the last trial</source>
        <translation>Zum letzten Versuch</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>%1: no answer</source>
        <translation>%1: keine Antwort</translation>
    </message>
    <message>
        <source>%1: %2, %3: %4. Each answer is kept at once; another one corrects it.</source>
        <translation>%1: %2, %3: %4. Jede Antwort wird sofort gespeichert; eine andere berichtigt sie.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::RatingPanel</name>
    <message>
        <source>Kept: effort %1, pain %2. Another number corrects it.</source>
        <translation>Behalten: Anstrengung %1, Schmerz %2. Eine andere Zahl berichtigt.</translation>
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
    <message>
        <source>Kept: effort %1, pain %2, shoulder %3. Another number corrects it.</source>
        <translation>Behalten: Anstrengung %1, Schmerz %2, Schulter %3. Eine andere Zahl berichtigt.</translation>
    </message>
    <message>
        <source>Correct: effort %1, pain %2, shoulder %3</source>
        <translation>Ändern: Anstrengung %1, Schmerz %2, Schulter %3</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <comment>beside its numbers</comment>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>Shoulder pain</source>
        <translation>Schulterschmerz</translation>
    </message>
    <message>
        <source>A number is missing: nothing is kept yet.</source>
        <translation>Eine Zahl fehlt: noch ist nichts behalten.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::RecordsCard</name>
    <message>
        <source>The records</source>
        <translation>Die Datenbank</translation>
    </message>
    <message>
        <source>Names, notes and goals are sealed. What somebody without a password changes is found at the login or by isograsp db check.</source>
        <translation>Namen, Notizen und Ziele sind versiegelt. Was jemand ohne Passwort verändert, wird bei der Anmeldung oder von isograsp db check gefunden.</translation>
    </message>
    <message>
        <source>Not hidden from whoever has the file: codes, dates, forces, the names of those who work here. Not noticed: an older copy of the file that is put back together with its FILE-audit.</source>
        <translation>Nicht verborgen vor dem, der die Datei hat: Kürzel, Daten, Kräfte, die Namen derer, die hier arbeiten. Nicht bemerkt: eine ältere Kopie der Datei, die zusammen mit ihrer FILE-audit zurückgelegt wird.</translation>
    </message>
    <message>
        <source>This database has no passphrase: whoever has the file can read all of it. What is changed, removed or added by another program is found by isograsp db check.</source>
        <translation>Diese Datenbank hat keine Passphrase: Wer die Datei hat, kann alles lesen. Was ein anderes Programm ändert, entfernt oder hinzufügt, findet isograsp db check.</translation>
    </message>
    <message>
        <source>Not noticed: changes by somebody who computes seals and log anew, and an older copy of the file that is put back. isograsp db protect gives the database a passphrase.</source>
        <translation>Nicht bemerkt: Änderungen von jemandem, der Siegel und Zugriffsprotokoll neu berechnet, und eine ältere Kopie der Datei, die zurückgelegt wird. isograsp db protect gibt der Datenbank eine Passphrase.</translation>
    </message>
    <message>
        <source>What helps: an encrypted disk, copies elsewhere, and on paper the head of the audit log and the key of signed backups (isograsp db audit).</source>
        <translation>Was hilft: ein verschlüsselter Datenträger, Kopien an anderem Ort, und auf Papier der Kopf des Zugriffsprotokolls und der Schlüssel unterschriebener Sicherungen (isograsp db audit).</translation>
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
        <translation>Mit &amp;Hilfe</translation>
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
    <message>
        <source>The patient&apos;s screen shows how a healthy arm does this task (F7, Alt+W)</source>
        <translation>Der Bildschirm des Patienten zeigt, wie ein gesunder Arm diese Aufgabe macht (F7, Alt+W)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SafetyForm</name>
    <message>
        <source>✓ The stop was pressed, and works.</source>
        <translation>✓ Der Stopp wurde gedrückt und geht.</translation>
    </message>
    <message>
        <source>Press the pedal (F9) or the stop key (F10) once, as a test.</source>
        <translation>Zur Probe einmal das Pedal (F9) oder die Stopptaste (F10) drücken.</translation>
    </message>
    <message>
        <source>✓ I stay within reach</source>
        <translation>✓ Ich bleibe in Reichweite</translation>
    </message>
    <message>
        <source>I stay within reach</source>
        <translation>Ich bleibe in Reichweite</translation>
    </message>
    <message>
        <source>As long as hands are strapped you can free them at any time; stored with the session (Tab, then space)</source>
        <translation>Solange Hände angegurtet sind, können Sie sie jederzeit befreien; wird mit der Sitzung gespeichert (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>The less affected hand lies unstrapped in its supports, so that it can help.</source>
        <translation>Die weniger betroffene Hand liegt ohne Gurte in ihren Auflagen, damit sie helfen kann.</translation>
    </message>
    <message>
        <source>It is strapped, too</source>
        <translation>Sie ist auch angegurtet</translation>
    </message>
    <message>
        <source>The less affected hand is strapped, too</source>
        <translation>Die weniger betroffene Hand ist auch angegurtet</translation>
    </message>
    <message>
        <source>Against the rule; stored with the session (Tab, then space)</source>
        <translation>Gegen die Regel; wird mit der Sitzung gespeichert (Tab, dann Leertaste)</translation>
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
    <message>
        <source>All measures</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>All measures of the trial in numbers (Ctrl+U)</source>
        <translation>Alle Maße des Versuchs in Zahlen (Strg+U)</translation>
    </message>
    <message>
        <source>Measures of the running or the last trial (Tab, arrow keys)</source>
        <translation>Maße des laufenden oder des letzten Versuchs (Tab, Pfeiltasten)</translation>
    </message>
    <message>
        <source>No earlier session to compare with</source>
        <translation>Keine frühere Sitzung zum Vergleich</translation>
    </message>
    <message>
        <source>Last time %1, on %2</source>
        <translation>Letztes Mal %1, am %2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScoreRow</name>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>%1: %2 of %3 (Tab, then arrow keys)</source>
        <translation>%1: %2 von %3 (Tab, dann Pfeiltasten)</translation>
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
    <message>
        <source>%1: %2 devices are left out: without a name or an address, or behind the first %3. Add them again in a session.</source>
        <translation>%1: %2 Geräte werden weggelassen: ohne Namen oder Adresse, oder hinter den ersten %3. Fügen Sie sie in einer Sitzung neu hinzu.</translation>
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
    <name>isograsp::gui::SizeOffer</name>
    <message>
        <source>It has the size of the left hand</source>
        <translation>Größe der linken Hand nehmen</translation>
    </message>
    <message>
        <source>It has the size of the right hand</source>
        <translation>Größe der rechten Hand nehmen</translation>
    </message>
    <message>
        <source>For a hand that cannot open: the other one, mirrored; stored with the session (Tab, then space)</source>
        <translation>Für eine Hand, die sich nicht öffnen kann: die andere, gespiegelt; wird mit der Sitzung gespeichert (Tab, dann Leertaste)</translation>
    </message>
    <message>
        <source>For a hand that cannot open. Measured in the entry test of %1.</source>
        <translation>Für eine Hand, die sich nicht öffnen kann. Gemessen im Eingangstest vom %1.</translation>
    </message>
    <message>
        <source>Size: that of the left hand, entry test of %1.</source>
        <translation>Größe: die der linken Hand, Eingangstest vom %1.</translation>
    </message>
    <message>
        <source>Size: that of the right hand, entry test of %1.</source>
        <translation>Größe: die der rechten Hand, Eingangstest vom %1.</translation>
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
        <source>Search patients</source>
        <translation>Patienten suchen</translation>
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
        <source>Search: code, treatment, protocol</source>
        <translation>Suche: Code, Behandlung, Protokoll</translation>
    </message>
    <message>
        <source>A part of the code, of a treatment, of a protocol, or of a name that is shown (Ctrl+F)</source>
        <translation>Ein Teil des Codes, einer Behandlung, eines Protokolls oder eines Namens, der gezeigt wird (Strg+F)</translation>
    </message>
    <message>
        <source>%1 more are found by the search.</source>
        <translation>%1 weitere findet die Suche.</translation>
    </message>
    <message>
        <source>Nobody is found by this text.</source>
        <translation>Mit diesem Text wird niemand gefunden.</translation>
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
    <message>
        <source>Both hands &amp;in, as last time</source>
        <translation>Beide Hände im Gerä&amp;t, wie letztes Mal</translation>
    </message>
    <message>
        <source>Both hands are &amp;in</source>
        <translation>Beide Hände im Gerä&amp;t</translation>
    </message>
    <message>
        <source>Left hand, as last time: %1.</source>
        <translation>Linke Hand, wie letztes Mal: %1.</translation>
    </message>
    <message>
        <source>Left hand, now: %1.</source>
        <translation>Linke Hand, jetzt: %1.</translation>
    </message>
    <message>
        <source>Right hand, as last time: %1.</source>
        <translation>Rechte Hand, wie letztes Mal: %1.</translation>
    </message>
    <message>
        <source>Right hand, now: %1.</source>
        <translation>Rechte Hand, jetzt: %1.</translation>
    </message>
    <message>
        <source>Left hand, not as last time: %1.</source>
        <translation>Linke Hand, nicht wie letztes Mal: %1.</translation>
    </message>
    <message>
        <source>Right hand, not as last time: %1.</source>
        <translation>Rechte Hand, nicht wie letztes Mal: %1.</translation>
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
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
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
    <message>
        <source>What is measured comes from software or a file, not from a person here</source>
        <translation>Was gemessen wird, kommt aus Software oder einer Datei, nicht von einem Menschen hier</translation>
    </message>
    <message>
        <source>Cameras: %1</source>
        <translation>Kameras: %1</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Tracker: %1</source>
        <translation>Handverfolgung: %1</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Tracker</translation>
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
        <source>Why it was held and let go</source>
        <translation>Warum gehalten und losgelassen wurde</translation>
    </message>
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
    <message>
        <source>Picture of both hands</source>
        <translation>Bild beider Hände</translation>
    </message>
    <message>
        <source>What the patient saw: the force of each hand and what was asked (Space)</source>
        <translation>Was zu sehen war: die Kraft jeder Hand und was verlangt war (Leertaste)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::VisitCard</name>
    <message>
        <source>tasks one by one</source>
        <translation>Aufgaben einzeln</translation>
    </message>
    <message>
        <source>TODAY</source>
        <translation>HEUTE</translation>
    </message>
    <message>
        <source>USUAL DAY</source>
        <translation>WIE SONST</translation>
    </message>
    <message>
        <source>Unfinished since %1: %2</source>
        <translation>Unvollendet seit %1: %2</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Als Nächstes: %1</translation>
    </message>
    <message>
        <source>Next: first session</source>
        <translation>Als Nächstes: erste Sitzung</translation>
    </message>
    <message>
        <source>Last session %1, %2</source>
        <translation>Letzte Sitzung %1, %2</translation>
    </message>
    <message>
        <source>No session yet; added %1</source>
        <translation>Noch keine Sitzung; hinzugefügt am %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Begin a session with %1</source>
        <translation>Eine Sitzung mit %1 beginnen</translation>
    </message>
    <message>
        <source>Enter on the card begins, too</source>
        <translation>Auch die Eingabetaste auf der Karte beginnt</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Sessions, measures and trials so far (Ctrl+2)</source>
        <translation>Bisherige Sitzungen, Maße und Versuche (Strg+2)</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Added by mistake: nothing is stored of this person; the log keeps that it was removed</source>
        <translation>Aus Versehen hinzugefügt: Von diesem Menschen ist nichts gespeichert; das Protokoll der Zugriffe behält, dass er entfernt wurde</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
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
    <message>
        <source>Both are empty: set &amp;zeros</source>
        <translation>Beide leer: &amp;Nullabgleich</translation>
    </message>
    <message>
        <source>Set the zeros of both empty platforms</source>
        <translation>Nullabgleich beider leeren Plattformen</translation>
    </message>
    <message>
        <source>With no hand in either: one quiet second becomes zero, of both at once (Alt+Z)</source>
        <translation>Ohne Hand in beiden: eine ruhige Sekunde wird Null, bei beiden zugleich (Alt+Z)</translation>
    </message>
    <message>
        <source>No hand in either, nothing touches the supports.</source>
        <translation>In keiner eine Hand, nichts berührt die Auflagen.</translation>
    </message>
    <message>
        <source>No hand, nothing touches the supports.</source>
        <translation>Keine Hand, nichts berührt die Auflagen.</translation>
    </message>
</context>
</TS>
