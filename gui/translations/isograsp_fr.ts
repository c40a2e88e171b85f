<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Arm</name>
    <message>
        <source>Brace</source>
        <translation>Attelle</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>Tronc</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Coude</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Avant-bras</translation>
    </message>
    <message>
        <source>Back of the hand</source>
        <translation>Dos de la main</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Forearm</source>
        <comment>a link that turns</comment>
        <translation>Avant-bras</translation>
    </message>
    <message>
        <source>Wrist</source>
        <translation>Poignet</translation>
    </message>
    <message>
        <source>Fingers</source>
        <translation>Doigts</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>vu</translation>
    </message>
    <message>
        <source>seen, one marker astray</source>
        <translation>vu, un marqueur écarté</translation>
    </message>
    <message>
        <source>too few markers</source>
        <translation>trop peu de marqueurs</translation>
    </message>
    <message>
        <source>markers on a line</source>
        <translation>marqueurs alignés</translation>
    </message>
    <message>
        <source>markers do not fit</source>
        <translation>marqueurs incohérents</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>non vu</translation>
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
        <translation>Inclinaison radiale</translation>
    </message>
    <message>
        <source>Ulnar deviation</source>
        <translation>Inclinaison cubitale</translation>
    </message>
    <message>
        <source>Shoulder pain or subluxation</source>
        <translation>Douleur ou subluxation d’épaule</translation>
    </message>
    <message>
        <source>Contracture</source>
        <translation>Rétraction</translation>
    </message>
    <message>
        <source>Tape allergy or broken skin</source>
        <translation>Allergie au ruban, peau lésée</translation>
    </message>
    <message>
        <source>Turns the forearm by 10°, unaided</source>
        <translation>Tourne seul l’avant-bras de 10°</translation>
    </message>
    <message>
        <source>Holds the object for 10 s</source>
        <translation>Tient l’objet 10 s</translation>
    </message>
    <message>
        <source>The arm is supported, and never pulled into its posture</source>
        <translation>Le bras est soutenu, jamais tiré dans une posture</translation>
    </message>
    <message>
        <source>Of elbow, forearm, wrist or fingers: measure the passive range and enter it below</source>
        <translation>Du coude, de l’avant-bras, du poignet ou des doigts&#xa0;: mesurer l’amplitude passive et l’inscrire plus bas</translation>
    </message>
    <message>
        <source>Where markers are put on: bands instead of tape</source>
        <translation>Là où sont les marqueurs&#xa0;: des bandes au lieu du ruban</translation>
    </message>
    <message>
        <source>Without it tasks of the arm are not offered</source>
        <translation>Sans cela, les tâches du bras ne sont pas proposées</translation>
    </message>
    <message>
        <source>Tasks of the arm need 10° of the forearm and 10 s of holding: take the isometric tasks of the hand instead.</source>
        <translation>Les tâches du bras demandent 10° de l’avant-bras et 10 s de tenue&#xa0;: prendre plutôt les tâches isométriques de la main.</translation>
    </message>
    <message>
        <source>Support the arm; stop where the shoulder hurts.</source>
        <translation>Soutenir le bras&#xa0;; arrêter là où l’épaule fait mal.</translation>
    </message>
    <message>
        <source>Enter the passive range: no target goes beyond it.</source>
        <translation>Inscrire l’amplitude passive&#xa0;: aucune cible ne la dépasse.</translation>
    </message>
    <message>
        <source>Markers on bands or clothes, no tape on the skin.</source>
        <translation>Marqueurs sur des bandes ou des vêtements, pas de ruban sur la peau.</translation>
    </message>
    <message>
        <source>A passive range has no angle in it: correct its numbers.</source>
        <translation>Une amplitude passive ne contient aucun angle&#xa0;: corriger ses nombres.</translation>
    </message>
    <message>
        <source>Own range</source>
        <translation>Amplitude propre</translation>
    </message>
    <message>
        <source>Small range: half of the way</source>
        <translation>Petite amplitude&#xa0;: mi-chemin</translation>
    </message>
    <message>
        <source>No movement</source>
        <translation>Aucun mouvement</translation>
    </message>
    <message>
        <source>own range</source>
        <translation>amplitude propre</translation>
    </message>
    <message>
        <source>small range</source>
        <translation>petite amplitude</translation>
    </message>
    <message>
        <source>no movement</source>
        <translation>aucun mouvement</translation>
    </message>
    <message>
        <source>%1, pain %2</source>
        <translation>%1, douleur %2</translation>
    </message>
    <message>
        <source>Supination / pronation</source>
        <translation>Supination / pronation</translation>
    </message>
    <message>
        <source>Extension / flexion</source>
        <translation>Extension / flexion</translation>
    </message>
    <message>
        <source>Radial / ulnar deviation</source>
        <translation>Inclinaison radiale / cubitale</translation>
    </message>
</context>
<context>
    <name>Compensation</name>
    <message>
        <source>This measures the shoulder, too: the arm pushes the platform with %1 % of the grip. Let it rest on the support.</source>
        <translation>L’épaule est mesurée aussi&#xa0;: le bras pousse la plateforme avec %1 % de la prise. Laissez-le reposer sur l’appui.</translation>
    </message>
    <message>
        <source>%1 moved %2 mm on its support: seat it anew.</source>
        <translation>%1&#xa0;: déplacé de %2 mm sur son appui, replacez-le.</translation>
    </message>
    <message>
        <source>%1 slips: more force into the object, less along it.</source>
        <translation>%1 glisse&#xa0;: plus de force vers l’objet, moins le long de l’objet.</translation>
    </message>
</context>
<context>
    <name>Consent</name>
    <message>
        <source>Treatment</source>
        <translation>Traitement</translation>
    </message>
    <message>
        <source>Research</source>
        <comment>purpose</comment>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Teaching</source>
        <translation>Enseignement</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Consentement</translation>
    </message>
    <message>
        <source>Contract</source>
        <translation>Contrat</translation>
    </message>
    <message>
        <source>Legal obligation</source>
        <translation>Obligation légale</translation>
    </message>
    <message>
        <source>Vital interests</source>
        <translation>Intérêts vitaux</translation>
    </message>
    <message>
        <source>Public interest</source>
        <translation>Intérêt public</translation>
    </message>
    <message>
        <source>Legitimate interest</source>
        <translation>Intérêt légitime</translation>
    </message>
    <message>
        <source>Care</source>
        <translation>Soins</translation>
    </message>
    <message>
        <source>Research</source>
        <comment>lawful basis</comment>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Art. 6 (1) a GDPR</source>
        <translation>art. 6 (1) a RGPD</translation>
    </message>
    <message>
        <source>Art. 6 (1) b GDPR</source>
        <translation>art. 6 (1) b RGPD</translation>
    </message>
    <message>
        <source>Art. 6 (1) c GDPR</source>
        <translation>art. 6 (1) c RGPD</translation>
    </message>
    <message>
        <source>Art. 6 (1) d GDPR</source>
        <translation>art. 6 (1) d RGPD</translation>
    </message>
    <message>
        <source>Art. 6 (1) e GDPR</source>
        <translation>art. 6 (1) e RGPD</translation>
    </message>
    <message>
        <source>Art. 6 (1) f GDPR</source>
        <translation>art. 6 (1) f RGPD</translation>
    </message>
    <message>
        <source>Art. 9 (2) h GDPR</source>
        <translation>art. 9 (2) h RGPD</translation>
    </message>
    <message>
        <source>Art. 9 (2) j GDPR</source>
        <translation>art. 9 (2) j RGPD</translation>
    </message>
    <message>
        <source>given</source>
        <translation>accordé</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>retiré</translation>
    </message>
    <message>
        <source>%1 %2: %3 on %4 (%5)</source>
        <translation>%1 %2&#xa0;: %3 le %4 (%5)</translation>
    </message>
    <message>
        <source>%1, recorded by %2</source>
        <translation>%1, enregistré par %2</translation>
    </message>
</context>
<context>
    <name>DeviceAddress</name>
    <message>
        <source>Force sensors on a CAN bus</source>
        <translation>Capteurs de force sur un bus CAN</translation>
    </message>
    <message>
        <source>Force sensors in the network</source>
        <translation>Capteurs de force sur le réseau</translation>
    </message>
    <message>
        <source>Force sensors on serial lines</source>
        <translation>Capteurs de force sur des lignes série</translation>
    </message>
    <message>
        <source>Cameras: Qualisys Track Manager</source>
        <translation>Caméras&#xa0;: Qualisys Track Manager</translation>
    </message>
    <message>
        <source>Cameras: OptiTrack Motive</source>
        <translation>Caméras&#xa0;: OptiTrack Motive</translation>
    </message>
    <message>
        <source>Tracked hand: Leap service</source>
        <translation>Main suivie&#xa0;: service Leap</translation>
    </message>
    <message>
        <source>Tracked hand: a script that sends it</source>
        <translation>Main suivie&#xa0;: un script qui l’envoie</translation>
    </message>
</context>
<context>
    <name>DeviceList</name>
    <message>
        <source>Force sensors on %1</source>
        <translation>Capteurs de force sur %1</translation>
    </message>
    <message>
        <source>Simulated patient, healthy</source>
        <translation>Patient simulé, sain</translation>
    </message>
    <message>
        <source>Simulated patient, paretic</source>
        <translation>Patient simulé, parétique</translation>
    </message>
    <message>
        <source>A recording …</source>
        <translation>Un enregistrement …</translation>
    </message>
    <message>
        <source>Arm, seen by cameras …</source>
        <translation>Bras, vu par des caméras …</translation>
    </message>
    <message>
        <source>Simulated arm, healthy</source>
        <translation>Bras simulé, sain</translation>
    </message>
    <message>
        <source>Simulated arm, paretic</source>
        <translation>Bras simulé, parétique</translation>
    </message>
    <message>
        <source>Simulated tracked hand, healthy</source>
        <translation>Main suivie simulée, saine</translation>
    </message>
    <message>
        <source>Simulated tracked hand, paretic</source>
        <translation>Main suivie simulée, parétique</translation>
    </message>
    <message>
        <source>Hand, by the Leap service here</source>
        <translation>Main, par le service Leap d’ici</translation>
    </message>
    <message>
        <source>Hand, by a script here</source>
        <translation>Main, par un script d’ici</translation>
    </message>
    <message>
        <source>Simulated, both healthy</source>
        <translation>Simulé, les deux saines</translation>
    </message>
    <message>
        <source>Simulated, left hand paretic</source>
        <translation>Simulé, main gauche parétique</translation>
    </message>
    <message>
        <source>Simulated, right hand paretic</source>
        <translation>Simulé, main droite parétique</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Enregistrement %1</translation>
    </message>
    <message>
        <source>Cameras at %1</source>
        <translation>Caméras à %1</translation>
    </message>
    <message>
        <source>Tracked hand at %1</source>
        <translation>Main suivie à %1</translation>
    </message>
    <message>
        <source>Add a device …</source>
        <translation>Ajouter un appareil …</translation>
    </message>
</context>
<context>
    <name>Flow</name>
    <message>
        <source>The hand is moved as Live hand says.</source>
        <translation>La main bouge comme l’indique «&#xa0;Main en direct&#xa0;».</translation>
    </message>
    <message>
        <source>Before the first object: check that the picture moves as the hand does.</source>
        <translation>Avant le premier objet&#xa0;: contrôler que l’image bouge comme la main.</translation>
    </message>
    <message>
        <source>Check the picture first, in Live hand.</source>
        <translation>Contrôlez d’abord l’image, dans «&#xa0;Main en direct&#xa0;».</translation>
    </message>
    <message>
        <source>The object is moved as Live arm says, seen by the patient.</source>
        <translation>L’objet est déplacé comme l’indique «&#xa0;Bras en direct&#xa0;», vu par la personne.</translation>
    </message>
    <message>
        <source>Before the first target: check that the picture moves as the object does.</source>
        <translation>Avant la première cible&#xa0;: contrôler que l’image bouge comme l’objet.</translation>
    </message>
    <message>
        <source>Check the picture first, in Live arm.</source>
        <translation>Contrôlez d’abord l’image, dans «&#xa0;Bras en direct&#xa0;».</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non connecté</translation>
    </message>
    <message>
        <source>Connecting …</source>
        <translation>Connexion …</translation>
    </message>
    <message>
        <source>Saving and disconnecting …</source>
        <translation>Enregistrement et déconnexion …</translation>
    </message>
    <message>
        <source>The recording is over</source>
        <translation>L’enregistrement est terminé</translation>
    </message>
    <message>
        <source>The device sends no more forces</source>
        <translation>L’appareil n’envoie plus de forces</translation>
    </message>
    <message>
        <source>No forces arrive: check the cable and power of the device</source>
        <translation>Aucune force n’arrive&#xa0;: vérifiez le câble et l’alimentation de l’appareil</translation>
    </message>
    <message>
        <source>Waiting for the first forces …</source>
        <translation>Attente des premières forces …</translation>
    </message>
    <message>
        <source>Connected, but samples were missing</source>
        <translation>Connecté, mais des échantillons manquaient</translation>
    </message>
    <message>
        <source>Measuring the empty device …</source>
        <translation>Mesure de l’appareil vide …</translation>
    </message>
    <message>
        <source>Connected, needs its zero</source>
        <translation>Connecté, mise à zéro à faire</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Maximum %1 N.</source>
        <translation>Maximum %1 N.</translation>
    </message>
    <message>
        <source>Hand strapped. It settles: %1 s until the resting force.</source>
        <translation>Main sanglée. Elle se stabilise&#xa0;: %1 s avant la force de repos.</translation>
    </message>
    <message>
        <source>The hand has settled. It relaxes: start the resting force.</source>
        <translation>La main est stabilisée. Elle se détend&#xa0;: lancez la force de repos.</translation>
    </message>
    <message>
        <source>%1 Strap the hand in and say so; after a minute start the resting force.</source>
        <translation>%1 Sanglez la main et confirmez-le&#xa0;; après une minute, lancez la force de repos.</translation>
    </message>
    <message>
        <source>Zero is set.</source>
        <translation>La mise à zéro est faite.</translation>
    </message>
    <message>
        <source>Take the hand out, then set the zero of the empty device once more.</source>
        <translation>Retirez la main, puis refaites la mise à zéro de l’appareil vide.</translation>
    </message>
    <message>
        <source>Pause: %1 s to rest.</source>
        <translation>Pause&#xa0;: %1 s de repos.</translation>
    </message>
    <message>
        <source>Next, in %1 s: %2.</source>
        <translation>Ensuite, dans %1 s&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Next: %1, after a rest of %2 s.</source>
        <translation>Ensuite&#xa0;: %1, après %2 s de repos.</translation>
    </message>
    <message>
        <source>Next: %1. Press Start.</source>
        <translation>Ensuite&#xa0;: %1. Lancez l’essai.</translation>
    </message>
    <message>
        <source>Setting the zero. Nobody touches the device.</source>
        <translation>Mise à zéro en cours. Personne ne touche l’appareil.</translation>
    </message>
    <message>
        <source>Recording: %1.</source>
        <translation>Mesure en cours&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Paused. Resume when the patient is ready.</source>
        <translation>En pause. Reprenez quand le patient est prêt.</translation>
    </message>
    <message>
        <source>The recording is over. Disconnect to end the session.</source>
        <translation>L’enregistrement est terminé. Déconnectez pour finir la séance.</translation>
    </message>
    <message>
        <source>Zero refused: %1</source>
        <translation>Mise à zéro refusée&#xa0;: %1</translation>
    </message>
    <message>
        <source>Device connected. Set the zero with the device empty.</source>
        <translation>Appareil connecté. Faites la mise à zéro, appareil vide.</translation>
    </message>
    <message>
        <source>Recording ready. Choose a task and press Start.</source>
        <translation>Enregistrement prêt. Choisissez une tâche et lancez l’essai.</translation>
    </message>
    <message>
        <source>%1 Next: the maximum grip force.</source>
        <translation>%1 Ensuite&#xa0;: la force maximale de préhension.</translation>
    </message>
    <message>
        <source>Resting force is known.</source>
        <translation>La force de repos est connue.</translation>
    </message>
    <message>
        <source>%1 Repeat it after one minute, or choose a task and press Start.</source>
        <translation>%1 Répétez après une minute, ou choisissez une tâche et lancez l’essai.</translation>
    </message>
    <message>
        <source>%1 Choose a task and press Start.</source>
        <translation>%1 Choisissez une tâche et lancez l’essai.</translation>
    </message>
    <message>
        <source>Trial stored. Repeat it, choose another task, or disconnect to end.</source>
        <translation>Essai enregistré. Répétez-le, choisissez une autre tâche, ou déconnectez pour finir.</translation>
    </message>
    <message>
        <source>Opening the database …</source>
        <translation>Ouverture de la base de données …</translation>
    </message>
    <message>
        <source>Connecting to the device …</source>
        <translation>Connexion à l’appareil …</translation>
    </message>
    <message>
        <source>Saving the session …</source>
        <translation>Enregistrement de la séance …</translation>
    </message>
    <message>
        <source>Choose a patient, or add a new one.</source>
        <translation>Choisissez un patient ou ajoutez-en un.</translation>
    </message>
    <message>
        <source>This is not the affected hand. Confirm it, or choose the other.</source>
        <translation>Ce n’est pas la main atteinte. Confirmez, ou choisissez l’autre.</translation>
    </message>
    <message>
        <source>Which hand is in the device today? Choose right or left.</source>
        <translation>Quelle main est dans l’appareil aujourd’hui&#xa0;? Choisissez droite ou gauche.</translation>
    </message>
    <message>
        <source>Ask the screening questions before any force.</source>
        <translation>Posez les questions de sécurité avant tout effort.</translation>
    </message>
    <message>
        <source>Looking whether this protocol was interrupted today …</source>
        <translation>Recherche d’une interruption de ce protocole aujourd’hui …</translation>
    </message>
    <message>
        <source>This protocol was interrupted today: go on, or begin anew?</source>
        <translation>Ce protocole a été interrompu aujourd’hui&#xa0;: reprendre ou recommencer&#xa0;?</translation>
    </message>
    <message>
        <source>Connect the device to begin the session.</source>
        <translation>Connectez l’appareil pour commencer la séance.</translation>
    </message>
    <message>
        <source>%1 The trial waits; nothing is lost.</source>
        <translation>%1 L’essai attend&#xa0;; rien n’est perdu.</translation>
    </message>
    <message>
        <source>Connect the device first.</source>
        <translation>Connectez d’abord l’appareil.</translation>
    </message>
    <message>
        <source>The recording is over.</source>
        <translation>L’enregistrement est terminé.</translation>
    </message>
    <message>
        <source>Set the zero first, with the device empty.</source>
        <translation>Faites d’abord la mise à zéro, appareil vide.</translation>
    </message>
    <message>
        <source>Wait until the zero is set.</source>
        <translation>Attendez la fin de la mise à zéro.</translation>
    </message>
    <message>
        <source>A trial is running.</source>
        <translation>Un essai est en cours.</translation>
    </message>
    <message>
        <source>The protocol is finished.</source>
        <translation>Le protocole est terminé.</translation>
    </message>
    <message>
        <source>Set the zero of the empty device once more.</source>
        <translation>Refaites la mise à zéro de l’appareil vide.</translation>
    </message>
    <message>
        <source>The strapped hand settles: %1 s.</source>
        <translation>La main sanglée se stabilise&#xa0;: %1 s.</translation>
    </message>
    <message>
        <source>Rest: %1 s.</source>
        <translation>Repos&#xa0;: %1 s.</translation>
    </message>
    <message>
        <source>The pause is over in a moment.</source>
        <translation>La pause se termine.</translation>
    </message>
    <message>
        <source>Choose a task.</source>
        <translation>Choisissez une tâche.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>Occupé</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>À faire</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>The device works again. The hand lets go; if Resume stays closed, stop, set the zero and repeat the trial.</source>
        <translation>L’appareil fonctionne de nouveau. La main relâche&#xa0;; si « Reprendre » reste fermé, arrêter, mettre à zéro et répéter l’essai.</translation>
    </message>
    <message>
        <source>The straps have been on for 20 minutes: look at the skin, then confirm that the hand is in and strapped.</source>
        <translation>Les sangles sont en place depuis 20 minutes&#xa0;: regardez la peau, puis confirmez que la main est en place et sanglée.</translation>
    </message>
    <message>
        <source>%1 Strap the hand in and say so; after a minute the resting force begins.</source>
        <translation>%1 Sanglez la main et confirmez-le&#xa0;; après une minute, la force de repos commence.</translation>
    </message>
    <message>
        <source>Hand strapped. It settles: %1 s, then the resting force begins.</source>
        <translation>Main sanglée. Elle se stabilise&#xa0;: %1 s, puis la force de repos commence.</translation>
    </message>
    <message>
        <source>Only to look: another program has this file open. Sessions begin there.</source>
        <translation>Lecture seule&#xa0;: un autre programme a ouvert ce fichier. Les séances commencent là-bas.</translation>
    </message>
    <message>
        <source>Next: %1, which cannot be made. Skip it.</source>
        <translation>Ensuite&#xa0;: %1, qui est impossible. Passez-le.</translation>
    </message>
    <message>
        <source>Zero is set. Strap the hand in again and say so.</source>
        <translation>La mise à zéro est faite. Sanglez de nouveau la main et confirmez-le.</translation>
    </message>
    <message>
        <source>The resting force is not known: choose it first, or go on without it.</source>
        <translation>La force de repos n’est pas connue&#xa0;: choisissez-la d’abord, ou continuez sans elle.</translation>
    </message>
    <message>
        <source>The device sends no more forces. Disconnect to end the session.</source>
        <translation>L’appareil n’envoie plus de forces. Déconnectez-le pour finir la séance.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Un instant …</translation>
    </message>
    <message>
        <source>Say first that the hand is in and strapped.</source>
        <translation>Confirmez d’abord que la main est en place et sanglée.</translation>
    </message>
    <message>
        <source>The cameras send no more pictures</source>
        <translation>Les caméras n’envoient plus d’images</translation>
    </message>
    <message>
        <source>No pictures arrive: check the computer of the cameras</source>
        <translation>Aucune image n’arrive&#xa0;: vérifiez l’ordinateur des caméras</translation>
    </message>
    <message>
        <source>Waiting for the first picture …</source>
        <translation>Attente de la première image …</translation>
    </message>
    <message>
        <source>Connected, but pictures were missing</source>
        <translation>Connecté, mais des images manquaient</translation>
    </message>
    <message>
        <source>Measuring the start posture …</source>
        <translation>Mesure de la posture de départ …</translation>
    </message>
    <message>
        <source>Connected, needs the start posture</source>
        <translation>Connecté, attend la posture de départ</translation>
    </message>
    <message>
        <source>The cameras send no more pictures. Disconnect to end the session.</source>
        <translation>Les caméras n’envoient plus d’images. Déconnectez-les pour finir la séance.</translation>
    </message>
    <message>
        <source>The start posture: the arm is held still.</source>
        <translation>La posture de départ&#xa0;: le bras reste immobile.</translation>
    </message>
    <message>
        <source>Paused: the cameras sent no pictures. Resume when they are back.</source>
        <translation>Pause&#xa0;: les caméras n’ont pas envoyé d’images. Reprenez quand elles sont revenues.</translation>
    </message>
    <message>
        <source>Start posture refused: %1</source>
        <translation>Posture de départ refusée&#xa0;: %1</translation>
    </message>
    <message>
        <source>The arm in the start posture, held still: measure it when the light says so.</source>
        <translation>Le bras immobile dans la posture de départ&#xa0;: mesurez quand le voyant le dit.</translation>
    </message>
    <message>
        <source>Wait until the start posture is measured.</source>
        <translation>Attendez que la posture de départ soit mesurée.</translation>
    </message>
    <message>
        <source>Measure the start posture first.</source>
        <translation>Mesurez d’abord la posture de départ.</translation>
    </message>
    <message>
        <source>Connecting to the cameras …</source>
        <translation>Connexion aux caméras …</translation>
    </message>
    <message>
        <source>Which arm works today? Choose right or left.</source>
        <translation>Quel bras travaille aujourd’hui&#xa0;? Choisir droite ou gauche.</translation>
    </message>
    <message>
        <source>Ask the screening questions before any movement.</source>
        <translation>Poser les questions de sécurité avant tout mouvement.</translation>
    </message>
    <message>
        <source>Connect the cameras to begin the session.</source>
        <translation>Connecter les caméras pour commencer la séance.</translation>
    </message>
    <message>
        <source>Which hand works today? Choose right or left.</source>
        <translation>Quelle main travaille aujourd’hui&#xa0;? Choisissez droite ou gauche.</translation>
    </message>
    <message>
        <source>Ask the screening questions before any work.</source>
        <translation>Posez les questions de sécurité avant tout travail.</translation>
    </message>
    <message>
        <source>Choose the device, or the cameras that see an arm.</source>
        <translation>Choisissez l’appareil, ou les caméras qui voient un bras.</translation>
    </message>
    <message>
        <source>Connect the cameras first.</source>
        <translation>Connectez d’abord les caméras.</translation>
    </message>
    <message>
        <source>Connect a device or cameras first.</source>
        <translation>Connectez d’abord un appareil ou des caméras.</translation>
    </message>
    <message>
        <source>Entry test: the hand lies still for ten seconds.</source>
        <translation>Test d’entrée&#xa0;: la main repose immobile dix secondes.</translation>
    </message>
    <message>
        <source>Entry test: the hand opens wide, then closes. %1 of %2.</source>
        <translation>Test d’entrée&#xa0;: la main s’ouvre grand, puis se ferme. %1 sur %2.</translation>
    </message>
    <message>
        <source>The tracker sends no more pictures</source>
        <translation>Le suivi de la main n’envoie plus d’images</translation>
    </message>
    <message>
        <source>Nothing arrives: check the tracker and its program</source>
        <translation>Rien n’arrive&#xa0;: vérifiez le suivi de la main et son programme</translation>
    </message>
    <message>
        <source>Entry test …</source>
        <translation>Test d’entrée …</translation>
    </message>
    <message>
        <source>Connected, needs the entry test</source>
        <translation>Connecté, le test d’entrée manque</translation>
    </message>
    <message>
        <source>Connecting to the tracker …</source>
        <translation>Connexion au suivi de la main …</translation>
    </message>
    <message>
        <source>Connect the tracker to begin the session.</source>
        <translation>Connectez le suivi de la main pour commencer la séance.</translation>
    </message>
    <message>
        <source>The tracker sends no more pictures. Disconnect to end the session.</source>
        <translation>Le suivi de la main n’envoie plus d’images. Déconnectez pour terminer la séance.</translation>
    </message>
    <message>
        <source>Paused: the tracker sent no hand. Resume when it works again.</source>
        <translation>En pause&#xa0;: le suivi n’envoyait pas de main. Reprenez quand il fonctionne de nouveau.</translation>
    </message>
    <message>
        <source>The hand is not seen. The trial goes on by itself.</source>
        <translation>La main n’est pas vue. L’essai continue de lui-même.</translation>
    </message>
    <message>
        <source>The hand lies on the table before the tracker: begin the entry test.</source>
        <translation>La main repose sur la table devant la caméra&#xa0;: commencez le test d’entrée.</translation>
    </message>
    <message>
        <source>Connect the tracker first.</source>
        <translation>Connectez d’abord le suivi de la main.</translation>
    </message>
    <message>
        <source>Do the entry test first.</source>
        <translation>Faites d’abord le test d’entrée.</translation>
    </message>
    <message>
        <source>No virtual objects for this hand: its entry test says so.</source>
        <translation>Pas d’objets virtuels pour cette main&#xa0;: son test d’entrée le dit.</translation>
    </message>
    <message>
        <source>Wait until the entry test is over.</source>
        <translation>Attendez la fin du test d’entrée.</translation>
    </message>
    <message>
        <source>Left platform: %1</source>
        <translation>Plateforme gauche&#xa0;: %1</translation>
    </message>
    <message>
        <source>Right platform: %1</source>
        <translation>Plateforme droite&#xa0;: %1</translation>
    </message>
    <message>
        <source>Ask the screening questions of each hand before any force.</source>
        <translation>Posez les questions de sécurité pour chaque main avant tout effort.</translation>
    </message>
    <message>
        <source>Connecting to both platforms …</source>
        <translation>Connexion aux deux plateformes …</translation>
    </message>
    <message>
        <source>Choose the platform of each hand.</source>
        <translation>Choisissez la plateforme de chaque main.</translation>
    </message>
    <message>
        <source>Connect both platforms to begin the session.</source>
        <translation>Connectez les deux plateformes pour commencer la séance.</translation>
    </message>
    <message>
        <source>Before the hands go in: press the pedal (F9) or the stop key (F10) once, as a test.</source>
        <translation>Avant d’installer les mains&#xa0;: appuyez une fois sur la pédale (F9) ou la touche d’arrêt (F10), comme essai.</translation>
    </message>
    <message>
        <source>The stop works. Confirm that you stay within reach.</source>
        <translation>L’arrêt fonctionne. Confirmez que vous restez à portée de main.</translation>
    </message>
    <message>
        <source>Put both hands in and say so; after a minute the resting force begins.</source>
        <translation>Installez les deux mains et confirmez-le&#xa0;; après une minute la force de repos commence.</translation>
    </message>
    <message>
        <source>Put both hands in and say so; after a minute start the resting force.</source>
        <translation>Installez les deux mains et confirmez-le&#xa0;; après une minute démarrez la force de repos.</translation>
    </message>
    <message>
        <source>Both zeros are set. Put both hands in again and say so.</source>
        <translation>Les deux mises à zéro sont faites. Réinstallez les deux mains et confirmez-le.</translation>
    </message>
    <message>
        <source>Both hands are in. They settle: %1 s, then the resting force begins.</source>
        <translation>Les deux mains sont en place. Elles se stabilisent&#xa0;: %1 s, puis la force de repos commence.</translation>
    </message>
    <message>
        <source>Both hands are in. They settle: %1 s until the resting force.</source>
        <translation>Les deux mains sont en place. Elles se stabilisent&#xa0;: %1 s jusqu’à la force de repos.</translation>
    </message>
    <message>
        <source>The hands have settled. They relax: start the resting force.</source>
        <translation>Les mains se sont stabilisées. Elles se détendent&#xa0;: démarrez la force de repos.</translation>
    </message>
    <message>
        <source>The straps have been on for 20 minutes: look at the skin, then confirm that the hands are in.</source>
        <translation>Les sangles sont en place depuis 20 minutes&#xa0;: regardez la peau, puis confirmez que les mains sont en place.</translation>
    </message>
    <message>
        <source>A platform sends no more forces</source>
        <translation>Une plateforme n’envoie plus de forces</translation>
    </message>
    <message>
        <source>No forces arrive: check cable and power of both platforms</source>
        <translation>Aucune force n’arrive&#xa0;: vérifiez le câble et l’alimentation des deux plateformes</translation>
    </message>
    <message>
        <source>Measuring both empty platforms …</source>
        <translation>Mesure des deux plateformes vides …</translation>
    </message>
    <message>
        <source>Connected, both need their zero</source>
        <translation>Connectées, mises à zéro à faire</translation>
    </message>
    <message>
        <source>A platform sends no more forces. Disconnect to end the session.</source>
        <translation>Une plateforme n’envoie plus de forces. Déconnectez pour terminer la séance.</translation>
    </message>
    <message>
        <source>Setting both zeros. Nobody touches the platforms.</source>
        <translation>Mises à zéro en cours. Personne ne touche les plateformes.</translation>
    </message>
    <message>
        <source>Both platforms connected. Set their zeros with both empty.</source>
        <translation>Les deux plateformes sont connectées. Faites la mise à zéro, les deux vides.</translation>
    </message>
    <message>
        <source>Take both hands out, then set the zeros of the empty platforms once more.</source>
        <translation>Retirez les deux mains, puis refaites la mise à zéro des plateformes vides.</translation>
    </message>
    <message>
        <source>The device works again. Both hands let go; if Resume stays closed, stop, set the zeros and repeat the trial.</source>
        <translation>L’appareil fonctionne de nouveau. Les deux mains relâchent&#xa0;; si « Reprendre » reste fermé, arrêter, mettre à zéro et répéter l’essai.</translation>
    </message>
    <message>
        <source>%1 Next: the maxima of both hands.</source>
        <translation>%1 Ensuite&#xa0;: les maxima des deux mains.</translation>
    </message>
    <message>
        <source>Resting forces are known.</source>
        <translation>Les forces de repos sont connues.</translation>
    </message>
    <message>
        <source>The maxima are known. Choose a task and press Start.</source>
        <translation>Les maxima sont connus. Choisissez une tâche et appuyez sur Démarrer.</translation>
    </message>
    <message>
        <source>Connect both platforms first.</source>
        <translation>Connectez d’abord les deux plateformes.</translation>
    </message>
    <message>
        <source>Set both zeros first, with both empty.</source>
        <translation>Faites d’abord la mise à zéro, les deux vides.</translation>
    </message>
    <message>
        <source>Wait until both zeros are set.</source>
        <translation>Attendez la fin des deux mises à zéro.</translation>
    </message>
    <message>
        <source>Set the zeros of the empty platforms once more.</source>
        <translation>Refaites la mise à zéro des plateformes vides.</translation>
    </message>
    <message>
        <source>Press the pedal (F9) or F10 once, as a test.</source>
        <translation>Appuyez une fois sur la pédale (F9) ou F10, comme essai.</translation>
    </message>
    <message>
        <source>Confirm first that you stay within reach.</source>
        <translation>Confirmez d’abord que vous restez à portée de main.</translation>
    </message>
    <message>
        <source>Say first that both hands are in.</source>
        <translation>Confirmez d’abord que les deux mains sont en place.</translation>
    </message>
    <message>
        <source>The hands settle: %1 s.</source>
        <translation>Les mains se stabilisent&#xa0;: %1 s.</translation>
    </message>
    <message>
        <source>One platform is pressed, nobody touches the other.</source>
        <translation>Une plateforme est pressée, personne ne touche l’autre.</translation>
    </message>
    <message>
        <source>Both zeros are set. Check whether the empty platforms move each other.</source>
        <translation>Les deux mises à zéro sont faites. Vérifiez si les plateformes vides se font bouger.</translation>
    </message>
    <message>
        <source>Check the platforms first, or skip that check.</source>
        <translation>Vérifiez d’abord les plateformes, ou passez cette vérification.</translation>
    </message>
    <message>
        <source>The protocol is finished. Print or write the report, then end the session.</source>
        <translation>Le protocole est terminé. Imprimez ou rédigez le rapport, puis terminez la séance.</translation>
    </message>
    <message>
        <source>Attention</source>
        <translation>Attention</translation>
    </message>
    <message>
        <source>The protocol is finished. Write the report, or disconnect to end.</source>
        <translation>Le protocole est terminé. Rédigez le rapport, ou déconnectez pour finir.</translation>
    </message>
    <message>
        <source>Ask the screening questions for the other arm. The cameras then connect by themselves.</source>
        <translation>Posez les questions de sécurité pour l’autre bras. Les caméras se connectent ensuite d’elles-mêmes.</translation>
    </message>
    <message>
        <source>Ask the screening questions for the other hand. The device then connects by itself.</source>
        <translation>Posez les questions de sécurité pour l’autre main. L’appareil se connecte ensuite de lui-même.</translation>
    </message>
</context>
<context>
    <name>FlowFault</name>
    <message>
        <source>All that was measured is stored.</source>
        <translation>Tout ce qui a été mesuré est enregistré.</translation>
    </message>
    <message>
        <source>The trial stands still.</source>
        <translation>L’essai est à l’arrêt.</translation>
    </message>
    <message>
        <source>The trial stands still; all up to %1 is stored.</source>
        <translation>L’essai est à l’arrêt&#xa0;; tout est enregistré jusqu’à %1.</translation>
    </message>
    <message>
        <source>No session has begun, and nothing was changed.</source>
        <translation>Aucune séance n’a commencé et rien n’a été modifié.</translation>
    </message>
    <message>
        <source>What is kept, and where, is said below.</source>
        <translation>Ce qui est conservé, et où, est dit au-dessous.</translation>
    </message>
    <message>
        <source>All up to %1 is stored.</source>
        <translation>Tout est enregistré jusqu’à %1.</translation>
    </message>
    <message>
        <source>Look at cables and power. Try again ends this session; the next one begins with the questions before it.</source>
        <translation>Vérifiez les câbles et l’alimentation. Réessayer termine cette séance&#xa0;; la suivante commence par les questions de sécurité.</translation>
    </message>
    <message>
        <source>Look at cables and power of the device. Try again ends this session; the next one begins with the questions before it.</source>
        <translation>Vérifiez les câbles et l’alimentation de l’appareil. Réessayer termine cette séance&#xa0;; la suivante commence par les questions de sécurité.</translation>
    </message>
    <message>
        <source>Look at cables and power: it goes on when data arrive again.</source>
        <translation>Vérifiez les câbles et l’alimentation&#xa0;: tout reprend dès que des données arrivent.</translation>
    </message>
    <message>
        <source>Resume when the picture is back.</source>
        <translation>Reprenez quand l’image est revenue.</translation>
    </message>
    <message>
        <source>When it works again, the hand lets go; then resume. If Resume stays closed: stop, set the zero, repeat the trial.</source>
        <translation>Quand il fonctionne à nouveau, la main relâche&#xa0;; puis reprenez. Si « Reprendre » reste fermé&#xa0;: arrêtez, réglez le zéro, répétez l’essai.</translation>
    </message>
</context>
<context>
    <name>Hand</name>
    <message>
        <source>%1: let go as well, the object was placed</source>
        <translation>%1&#xa0;: lâché également, l’objet était posé</translation>
    </message>
    <message>
        <source>%1: tied, this grasp holds (%2)</source>
        <translation>%1&#xa0;: lié, cette prise tient (%2)</translation>
    </message>
    <message>
        <source>%1: tied, the grasp of %2 holds (%3)</source>
        <translation>%1&#xa0;: lié, la prise de %2 tient (%3)</translation>
    </message>
    <message>
        <source>%1: let go, pulled with %2 N &gt; %3 N</source>
        <translation>%1&#xa0;: lâché, traction %2 N &gt; %3 N</translation>
    </message>
    <message>
        <source>%1: let go, what was left held nothing</source>
        <translation>%1&#xa0;: lâché, ce qui restait ne tenait rien</translation>
    </message>
    <message>
        <source>%1: let go for the person</source>
        <translation>%1&#xa0;: lâché pour la personne</translation>
    </message>
    <message>
        <source>The object was dropped</source>
        <translation>L’objet est tombé</translation>
    </message>
    <message>
        <source>%1: loose, the placement is over</source>
        <translation>%1&#xa0;: libre, le placement est terminé</translation>
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
        <translation>Pouce</translation>
    </message>
    <message>
        <source>Index finger</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Middle finger</source>
        <translation>Majeur</translation>
    </message>
    <message>
        <source>Ring finger</source>
        <translation>Annulaire</translation>
    </message>
    <message>
        <source>Little finger</source>
        <translation>Auriculaire</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>touche</translation>
    </message>
    <message>
        <source>tied</source>
        <translation>lié</translation>
    </message>
    <message>
        <source>has let go</source>
        <translation>a lâché</translation>
    </message>
    <message>
        <source>full</source>
        <translation>pleine</translation>
    </message>
    <message>
        <source>softer</source>
        <translation>plus douce</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
</context>
<context>
    <name>HandScreening</name>
    <message>
        <source>Shoulder pain or subluxation</source>
        <translation>Douleur ou subluxation de l’épaule</translation>
    </message>
    <message>
        <source>The hand is carried to its targets: support the forearm</source>
        <translation>La main se porte vers ses cibles&#xa0;: soutenez l’avant-bras</translation>
    </message>
    <message>
        <source>Stop where the shoulder hurts.</source>
        <translation>Arrêtez où l’épaule fait mal.</translation>
    </message>
    <message>
        <source>Support the forearm; stop where the shoulder hurts.</source>
        <translation>Soutenez l’avant-bras&#xa0;; arrêtez où l’épaule fait mal.</translation>
    </message>
    <message>
        <source>Mark the treatment on the patient&apos;s page.</source>
        <translation>Notez le traitement sur la page du patient.</translation>
    </message>
    <message>
        <source>Stay beside the patient.</source>
        <translation>Restez auprès du patient.</translation>
    </message>
    <message>
        <source>may move, pain %1</source>
        <translation>peut bouger, douleur %1</translation>
    </message>
    <message>
        <source>no movement, pain %1</source>
        <translation>pas de mouvement, douleur %1</translation>
    </message>
</context>
<context>
    <name>LibraryPreview</name>
    <message>
        <source>%1, at most %2</source>
        <translation>%1, au plus %2</translation>
    </message>
    <message>
        <source>Target (N)</source>
        <translation>Cible (N)</translation>
    </message>
    <message>
        <source>Target (% of the maximum)</source>
        <translation>Cible (% du maximum)</translation>
    </message>
    <message>
        <source>Target (% of the comfortable force)</source>
        <translation>Cible (% de la force confortable)</translation>
    </message>
    <message>
        <source>Target (% of the baseline)</source>
        <translation>Cible (% du niveau initial)</translation>
    </message>
    <message>
        <source>%1 of the target (%2)</source>
        <translation>%1 de la cible (%2)</translation>
    </message>
    <message>
        <source>maximum: %1</source>
        <translation>maximum&#xa0;: %1</translation>
    </message>
    <message>
        <source>comfortable force: %1</source>
        <translation>force confortable&#xa0;: %1</translation>
    </message>
    <message>
        <source>baseline: %1</source>
        <translation>niveau initial&#xa0;: %1</translation>
    </message>
    <message>
        <source>The patient reads</source>
        <translation>Le patient lit</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Takes</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Measured before</source>
        <translation>À mesurer avant</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Difficulté</translation>
    </message>
    <message>
        <source>may be chosen or follow success: for training, not assessment</source>
        <translation>au choix ou selon la réussite&#xa0;: pour l’entraînement, pas pour un bilan</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Cibles</translation>
    </message>
    <message>
        <source>Instrument zero</source>
        <translation>Mise à zéro de l’appareil</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 (%2 to %3 times)</source>
        <translation>%1 (%2 à %3 fois)</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n time(s))</source>
        <translation>
            <numerusform>%1 (%n fois)</numerusform>
            <numerusform>%1 (%n fois)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1, entraînement</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
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
        <translation>Posture de départ</translation>
    </message>
    <message>
        <source>Entry test of the hand</source>
        <translation>Test d’entrée de la main</translation>
    </message>
    <message>
        <source>Postures</source>
        <translation>Postures</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>left, mirrored</source>
        <translation>gauche, en miroir</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>An own task names them</source>
        <translation>Une tâche propre les nomme</translation>
    </message>
</context>
<context>
    <name>PatientScreen</name>
    <message>
        <source>Thumb and index</source>
        <translation>Pouce et index</translation>
    </message>
    <message>
        <source>Thumb</source>
        <translation>Pouce</translation>
    </message>
    <message>
        <source>Index finger</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Middle finger</source>
        <translation>Majeur</translation>
    </message>
    <message>
        <source>All fingers</source>
        <translation>Tous les doigts</translation>
    </message>
    <message>
        <source>Pinch: thumb and index</source>
        <translation>Pincez&#xa0;: pouce et index</translation>
    </message>
    <message>
        <source>Press with all fingers</source>
        <translation>Appuyez avec tous les doigts</translation>
    </message>
    <message>
        <source>Press with the thumb only</source>
        <translation>Appuyez avec le pouce seul</translation>
    </message>
    <message>
        <source>Press with the index finger only</source>
        <translation>Appuyez avec l’index seul</translation>
    </message>
    <message>
        <source>Press with the middle finger only</source>
        <translation>Appuyez avec le majeur seul</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Serrez</translation>
    </message>
    <message>
        <source>Open your hand</source>
        <translation>Ouvrez la main</translation>
    </message>
    <message>
        <source>Open thumb and index</source>
        <translation>Ouvrez le pouce et l’index</translation>
    </message>
    <message>
        <source>%1: pull back</source>
        <translation>%1&#xa0;: reculez</translation>
    </message>
    <message>
        <source>%1: pull toward you</source>
        <translation>%1&#xa0;: tirez vers vous</translation>
    </message>
    <message>
        <source>%1: push away</source>
        <translation>%1&#xa0;: repoussez</translation>
    </message>
    <message>
        <source>Thumb toward you, index away</source>
        <translation>Pouce vers vous, index au loin</translation>
    </message>
    <message>
        <source>Thumb away, index toward you</source>
        <translation>Pouce au loin, index vers vous</translation>
    </message>
    <message>
        <source>Thumb toward you, fingers away</source>
        <translation>Pouce vers vous, doigts au loin</translation>
    </message>
    <message>
        <source>Thumb away, fingers toward you</source>
        <translation>Pouce au loin, doigts vers vous</translation>
    </message>
    <message>
        <source>%1: push up</source>
        <translation>%1&#xa0;: poussez vers le haut</translation>
    </message>
    <message>
        <source>%1: push down</source>
        <translation>%1&#xa0;: poussez vers le bas</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Take your hand out</source>
        <translation>Retirez la main</translation>
    </message>
    <message>
        <source>Please take it out of the device.</source>
        <translation>Retirez-la de l’appareil, s’il vous plaît.</translation>
    </message>
    <message>
        <source>Let your hand rest</source>
        <translation>Laissez la main au repos</translation>
    </message>
    <message>
        <source>Do nothing. Breathe calmly.</source>
        <translation>Ne faites rien. Respirez calmement.</translation>
    </message>
    <message>
        <source>%1!</source>
        <translation>%1&#xa0;!</translation>
    </message>
    <message>
        <source>As hard as you can. Breathe out.</source>
        <translation>Aussi fort que possible. Expirez.</translation>
    </message>
    <message>
        <source>Squeeze comfortably</source>
        <translation>Serrez sans forcer</translation>
    </message>
    <message>
        <source>Hold it. Breathe calmly.</source>
        <translation>Tenez. Respirez calmement.</translation>
    </message>
    <message>
        <source>Press comfortably</source>
        <translation>Appuyez sans forcer</translation>
    </message>
    <message>
        <source>Open comfortably</source>
        <translation>Ouvrez sans forcer</translation>
    </message>
    <message>
        <source>Push comfortably</source>
        <translation>Poussez sans forcer</translation>
    </message>
    <message>
        <source>Follow the line</source>
        <translation>Suivez la ligne</translation>
    </message>
    <message>
        <source>Squeeze harder: the dot goes up</source>
        <translation>Serrez plus fort&#xa0;: le point monte</translation>
    </message>
    <message>
        <source>Keep the dot on the line</source>
        <translation>Gardez le point sur la ligne</translation>
    </message>
    <message>
        <source>The same force again</source>
        <translation>Encore la même force</translation>
    </message>
    <message>
        <source>Without looking, as before.</source>
        <translation>Sans regarder, comme avant.</translation>
    </message>
    <message>
        <source>Let go!</source>
        <translation>Relâchez&#xa0;!</translation>
    </message>
    <message>
        <source>As fast as you can.</source>
        <translation>Aussi vite que possible.</translation>
    </message>
    <message>
        <source>Bring it to the outline</source>
        <translation>Amenez-le au contour</translation>
    </message>
    <message>
        <source>Slowly and level</source>
        <translation>Lentement et bien droit</translation>
    </message>
    <message>
        <source>Disc into the ring, same size</source>
        <translation>Disque dans l’anneau, même taille</translation>
    </message>
    <message>
        <source>%1: fill the ring</source>
        <translation>%1&#xa0;: remplissez l’anneau</translation>
    </message>
    <message>
        <source>Fill every ring</source>
        <translation>Remplissez chaque anneau</translation>
    </message>
    <message>
        <source>Stay on the outline</source>
        <translation>Restez sur le contour</translation>
    </message>
    <message>
        <source>It moves: go with it</source>
        <translation>Il bouge&#xa0;: suivez-le</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Relâchez</translation>
    </message>
    <message>
        <source>Leave it there</source>
        <translation>Laissez-le là</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>Tenez-le immobile</translation>
    </message>
    <message>
        <source>Until the ring is full</source>
        <translation>Jusqu’à ce que l’anneau soit plein</translation>
    </message>
    <message>
        <source>Take it and carry it there</source>
        <translation>Prenez-le et portez-le là</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Ensuite&#xa0;: %1</translation>
    </message>
    <message>
        <source>Get ready</source>
        <translation>Préparez-vous</translation>
    </message>
    <message>
        <source>Without seeing your force</source>
        <translation>Sans voir votre force</translation>
    </message>
    <message>
        <source>Hold it and wait for the word</source>
        <translation>Tenez et attendez le signal</translation>
    </message>
    <message>
        <source>Hold it steady on the line</source>
        <translation>Restez stable sur la ligne</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenue</translation>
    </message>
    <message>
        <source>We will begin in a moment.</source>
        <translation>Nous allons commencer.</translation>
    </message>
    <message>
        <source>Hands off, please</source>
        <translation>Ne touchez pas, s’il vous plaît</translation>
    </message>
    <message>
        <source>The device measures itself.</source>
        <translation>L’appareil se mesure lui-même.</translation>
    </message>
    <message>
        <source>Well done</source>
        <translation>Très bien</translation>
    </message>
    <message>
        <source>Relax your arm.</source>
        <translation>Relâchez le bras.</translation>
    </message>
    <message>
        <source>Relax your hand.</source>
        <translation>Détendez la main.</translation>
    </message>
    <message>
        <source>Please take your hand out of the device</source>
        <translation>Retirez la main de l’appareil</translation>
    </message>
    <message>
        <source>Relax your arm</source>
        <translation>Relâchez le bras</translation>
    </message>
    <message>
        <source>Relax your hand</source>
        <translation>Détendez la main</translation>
    </message>
    <message>
        <source>The next task will begin in a moment.</source>
        <translation>La prochaine tâche va commencer.</translation>
    </message>
    <message>
        <source>The device needs help. You did nothing wrong. Relax your hand.</source>
        <translation>L’appareil a besoin d’aide. Vous n’avez rien fait de mal. Détendez la main.</translation>
    </message>
    <message>
        <source>Pause. Relax your arm.</source>
        <translation>Pause. Relâchez le bras.</translation>
    </message>
    <message>
        <source>Pause. Relax your hand.</source>
        <translation>Pause. Détendez la main.</translation>
    </message>
    <message>
        <source>Watch how it is done</source>
        <translation>Regardez comment on fait</translation>
    </message>
    <message>
        <source>Good try</source>
        <translation>Bel essai</translation>
    </message>
    <message>
        <source>Turn the hand towards the cameras</source>
        <translation>Tournez la main vers les caméras</translation>
    </message>
    <message>
        <source>It goes on by itself</source>
        <translation>Cela reprend tout seul</translation>
    </message>
    <message>
        <source>Stay there until the next picture</source>
        <translation>Restez là jusqu’à la prochaine image</translation>
    </message>
    <message>
        <source>Hold your arm still</source>
        <translation>Gardez le bras immobile</translation>
    </message>
    <message>
        <source>For a moment, in the start posture</source>
        <translation>Un instant, dans la posture de départ</translation>
    </message>
    <message>
        <source>Take it in your hand again</source>
        <translation>Reprenez l’objet en main</translation>
    </message>
    <message>
        <source>As far as it goes.</source>
        <translation>Autant que possible.</translation>
    </message>
    <message>
        <source>Close your hand</source>
        <translation>Fermez la main</translation>
    </message>
    <message>
        <source>The cameras need help. You did nothing wrong. Relax your arm.</source>
        <translation>Les caméras ont besoin d’aide. Vous n’avez rien fait de mal. Relâchez le bras.</translation>
    </message>
    <message>
        <source>Please show your right hand</source>
        <translation>Montrez la main droite</translation>
    </message>
    <message>
        <source>Please show your left hand</source>
        <translation>Montrez la main gauche</translation>
    </message>
    <message>
        <source>Show your hand to the camera</source>
        <translation>Montrez la main à la caméra</translation>
    </message>
    <message>
        <source>It appears here by itself</source>
        <translation>Elle apparaît ici d’elle-même</translation>
    </message>
    <message>
        <source>Your hand is out of sight</source>
        <translation>La main n’est pas vue</translation>
    </message>
    <message>
        <source>It stands still here and goes on by itself</source>
        <translation>Elle reste immobile ici, puis cela reprend tout seul</translation>
    </message>
    <message>
        <source>The next object comes in a moment</source>
        <translation>L’objet suivant arrive dans un instant</translation>
    </message>
    <message>
        <source>The object lets go by itself</source>
        <translation>L’objet se détache de lui-même</translation>
    </message>
    <message>
        <source>It is in place: open your hand</source>
        <translation>Il est en place, ouvrez la main</translation>
    </message>
    <message>
        <source>Lift your hand</source>
        <translation>Levez la main</translation>
    </message>
    <message>
        <source>It is below the table</source>
        <translation>Elle est sous la table</translation>
    </message>
    <message>
        <source>Bring it to the blue shape</source>
        <translation>Amenez-le à la forme bleue</translation>
    </message>
    <message>
        <source>The line shows the way</source>
        <translation>La ligne montre le chemin</translation>
    </message>
    <message>
        <source>Take the object</source>
        <translation>Prenez l’objet</translation>
    </message>
    <message>
        <source>Then bring it to the blue shape</source>
        <translation>Puis amenez-le à la forme bleue</translation>
    </message>
    <message>
        <source>As far as it goes</source>
        <translation>Aussi loin que possible</translation>
    </message>
    <message>
        <source>Rest your hand</source>
        <translation>Laissez la main au repos</translation>
    </message>
    <message>
        <source>Keep it still, where it can be seen</source>
        <translation>Immobile et bien visible</translation>
    </message>
    <message>
        <source>Opened %1 of %2 times</source>
        <translation>Ouverte %1 fois sur %2</translation>
    </message>
    <message>
        <source>Help: full</source>
        <translation>Aide&#xa0;: complète</translation>
    </message>
    <message>
        <source>Help: a little</source>
        <translation>Aide&#xa0;: légère</translation>
    </message>
    <message>
        <source>Without help</source>
        <translation>Sans aide</translation>
    </message>
    <message>
        <source>The camera needs help. You did nothing wrong. Relax your hand.</source>
        <translation>La caméra a besoin d’aide. Vous n’avez rien fait de mal. Détendez la main.</translation>
    </message>
    <message>
        <source>Relax both hands.</source>
        <translation>Détendez les deux mains.</translation>
    </message>
    <message>
        <source>The device needs help. You did nothing wrong. Relax both hands.</source>
        <translation>L’appareil a besoin d’aide. Vous n’avez rien fait de mal. Détendez les deux mains.</translation>
    </message>
    <message>
        <source>Pause. Relax both hands.</source>
        <translation>Pause. Détendez les deux mains.</translation>
    </message>
    <message>
        <source>squeezes</source>
        <translation>serre</translation>
    </message>
    <message>
        <source>presses</source>
        <translation>appuie</translation>
    </message>
    <message>
        <source>at rest</source>
        <comment>the other hand works</comment>
        <translation>au repos</translation>
    </message>
    <message>
        <source>rests</source>
        <translation>se repose</translation>
    </message>
    <message>
        <source>Next: both hands</source>
        <translation>Ensuite&#xa0;: les deux mains</translation>
    </message>
    <message>
        <source>Next: left hand</source>
        <translation>Ensuite&#xa0;: la main gauche</translation>
    </message>
    <message>
        <source>Next: right hand</source>
        <translation>Ensuite&#xa0;: la main droite</translation>
    </message>
    <message>
        <source>Let both hands rest</source>
        <translation>Laissez les deux mains au repos</translation>
    </message>
    <message>
        <source>Squeeze with both hands!</source>
        <translation>Serrez avec les deux mains&#xa0;!</translation>
    </message>
    <message>
        <source>Squeeze with the left hand!</source>
        <translation>Serrez avec la main gauche&#xa0;!</translation>
    </message>
    <message>
        <source>Squeeze with the right hand!</source>
        <translation>Serrez avec la main droite&#xa0;!</translation>
    </message>
    <message>
        <source>Press with both hands</source>
        <translation>Appuyez avec les deux mains</translation>
    </message>
    <message>
        <source>Together up to the line</source>
        <translation>Ensemble jusqu’à la ligne</translation>
    </message>
    <message>
        <source>Each hand up to its line</source>
        <translation>Chaque main jusqu’à sa ligne</translation>
    </message>
    <message>
        <source>Press with the left hand</source>
        <translation>Appuyez avec la main gauche</translation>
    </message>
    <message>
        <source>Press with the right hand</source>
        <translation>Appuyez avec la main droite</translation>
    </message>
    <message>
        <source>Other hand at rest</source>
        <translation>Autre main au repos</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Main gauche</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Main droite</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Ensemble</translation>
    </message>
    <message>
        <source>The devices measure themselves.</source>
        <translation>Les appareils se mesurent eux-mêmes.</translation>
    </message>
    <message>
        <source>Please take both hands out of the devices</source>
        <translation>Retirez les deux mains des appareils</translation>
    </message>
    <message>
        <source>Relax both hands</source>
        <translation>Détendez les deux mains</translation>
    </message>
    <message>
        <source>Press the ends together</source>
        <translation>Serrez les deux bouts</translation>
    </message>
    <message>
        <source>It slides: press more firmly</source>
        <translation>Il glisse&#xa0;: serrez plus fort</translation>
    </message>
    <message>
        <source>Then lift it with both hands</source>
        <translation>Puis soulevez-le des deux mains</translation>
    </message>
    <message>
        <source>Lift it with both hands</source>
        <translation>Soulevez-le des deux mains</translation>
    </message>
    <message>
        <source>The left end is too low</source>
        <translation>Le bout gauche est trop bas</translation>
    </message>
    <message>
        <source>The right end is too low</source>
        <translation>Le bout droit est trop bas</translation>
    </message>
    <message>
        <source>Level, into the band</source>
        <translation>À l&apos;horizontale, dans la bande</translation>
    </message>
    <message>
        <source>It slipped: let both hands rest</source>
        <translation>Il a glissé&#xa0;: laissez reposer les deux mains</translation>
    </message>
    <message>
        <source>You may lift it again in a moment</source>
        <translation>Vous pourrez bientôt le soulever à nouveau</translation>
    </message>
    <message>
        <source>lifts</source>
        <translation>soulève</translation>
    </message>
    <message>
        <source>Carry it to the outline</source>
        <translation>Portez-la dans le contour</translation>
    </message>
    <message>
        <source>It was let go: let both hands rest</source>
        <translation>Elle a été lâchée&#xa0;: laissez reposer les deux mains</translation>
    </message>
    <message>
        <source>Keep pressing from both sides</source>
        <translation>Continuez d&apos;appuyer des deux côtés</translation>
    </message>
    <message>
        <source>One from each side</source>
        <translation>Une de chaque côté</translation>
    </message>
    <message>
        <source>Press both hands against the box</source>
        <translation>Appuyez les deux mains contre la boîte</translation>
    </message>
    <message>
        <source>Relax them, then leave the pedal</source>
        <translation>Relâchez-les, puis quittez la pédale</translation>
    </message>
    <message>
        <source>You may take it again in a moment</source>
        <translation>Vous pourrez la reprendre dans un instant</translation>
    </message>
    <message>
        <source>Your hands stay where they are</source>
        <translation>Vos mains restent où elles sont</translation>
    </message>
    <message>
        <source>carries</source>
        <translation>porte</translation>
    </message>
    <message>
        <source>lets go</source>
        <translation>lâche</translation>
    </message>
</context>
<context>
    <name>Posture</name>
    <message>
        <source>chair with back</source>
        <translation>chaise à dossier</translation>
    </message>
    <message>
        <source>wheelchair</source>
        <translation>fauteuil roulant</translation>
    </message>
    <message>
        <source>edge of the bed</source>
        <translation>bord du lit</translation>
    </message>
    <message>
        <source>in bed</source>
        <translation>au lit</translation>
    </message>
    <message>
        <source>on the table</source>
        <translation>sur la table</translation>
    </message>
    <message>
        <source>in a trough</source>
        <translation>dans une gouttière</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>neutral</source>
        <translation>neutre</translation>
    </message>
    <message>
        <source>extended</source>
        <translation>en extension</translation>
    </message>
    <message>
        <source>flexed</source>
        <translation>en flexion</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>wrist splint</source>
        <translation>attelle de poignet</translation>
    </message>
    <message>
        <source>hand splint</source>
        <translation>attelle de main</translation>
    </message>
    <message>
        <source>another one</source>
        <translation>une autre</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>Siège</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Coude</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Avant-bras</translation>
    </message>
    <message>
        <source>Wrist</source>
        <translation>Poignet</translation>
    </message>
    <message>
        <source>Orthosis</source>
        <translation>Orthèse</translation>
    </message>
    <message>
        <source>Supports at</source>
        <translation>Appuis à</translation>
    </message>
    <message>
        <source>Straps at</source>
        <translation>Sangles à</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1&#xa0;: %2 au lieu de %3</translation>
    </message>
</context>
<context>
    <name>Presentation</name>
    <message>
        <source>left half</source>
        <translation>moitié gauche</translation>
    </message>
    <message>
        <source>right half</source>
        <translation>moitié droite</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>calme</translation>
    </message>
    <message>
        <source>sounds</source>
        <translation>sons</translation>
    </message>
    <message>
        <source>force heard</source>
        <translation>force audible</translation>
    </message>
    <message>
        <source>spoken</source>
        <translation>parlé</translation>
    </message>
</context>
<context>
    <name>Profile</name>
    <message>
        <source>Give year, month and day, such as %1.</source>
        <translation>Indiquez le jour, le mois et l’année, par exemple %1.</translation>
    </message>
    <message>
        <source>“%1” is no day of the calendar. Give year, month and day, such as %2.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un jour du calendrier. Indiquez le jour, le mois et l’année, par exemple %2.</translation>
    </message>
    <message>
        <source>The year of “%1” cannot be right: it is not between %2 and %3.</source>
        <translation>L’année de «&#xa0;%1&#xa0;» ne peut être juste&#xa0;: elle n’est pas entre %2 et %3.</translation>
    </message>
    <message>
        <source>%1 has not come yet.</source>
        <translation>Le %1 n’est pas encore arrivé.</translation>
    </message>
    <message>
        <source>Give the score.</source>
        <translation>Indiquez le score.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>%1 is not possible. %2.</source>
        <translation>%1 n’est pas possible. %2.</translation>
    </message>
    <message>
        <source>The onset is today.</source>
        <translation>Le début est aujourd’hui.</translation>
    </message>
    <message>
        <source>1 day since the onset.</source>
        <translation>1 jour depuis le début.</translation>
    </message>
    <message>
        <source>%1 days since the onset.</source>
        <translation>%1 jours depuis le début.</translation>
    </message>
    <message>
        <source>Botulinum toxin</source>
        <translation>Toxine botulique</translation>
    </message>
    <message>
        <source>Drug</source>
        <translation>Médicament</translation>
    </message>
    <message>
        <source>Orthosis</source>
        <translation>Orthèse</translation>
    </message>
    <message>
        <source>Therapy</source>
        <translation>Thérapie</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>Action Research Arm Test</source>
        <translation>Action Research Arm Test</translation>
    </message>
    <message>
        <source>Fugl-Meyer Assessment, arm and hand</source>
        <translation>Évaluation de Fugl-Meyer, bras et main</translation>
    </message>
    <message>
        <source>Box and Block Test</source>
        <translation>Box and Block Test</translation>
    </message>
    <message>
        <source>Nine-Hole Peg Test</source>
        <translation>Test des neuf chevilles</translation>
    </message>
    <message>
        <source>Motor Activity Log</source>
        <translation>Motor Activity Log</translation>
    </message>
    <message>
        <source>Modified Ashworth Scale</source>
        <translation>Échelle d’Ashworth modifiée</translation>
    </message>
    <message>
        <source>Sensation, as your clinic counts it</source>
        <translation>Sensibilité, selon le barème de votre clinique</translation>
    </message>
    <message>
        <source>%1: any number</source>
        <translation>%1&#xa0;: tout nombre</translation>
    </message>
    <message>
        <source>%1: more than %2 seconds</source>
        <translation>%1&#xa0;: plus de %2 secondes</translation>
    </message>
    <message>
        <source>%1: %2 blocks or more</source>
        <translation>%1&#xa0;: %2 blocs ou plus</translation>
    </message>
    <message>
        <source>%1: %2 to %3</source>
        <translation>%1&#xa0;: %2 à %3</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 blocks</source>
        <translation>%1 blocs</translation>
    </message>
</context>
<context>
    <name>ProtocolGuide</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 et %n autre</numerusform>
            <numerusform>%1 et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Zero, device empty</source>
        <translation>Mise à zéro, appareil vide</translation>
    </message>
    <message>
        <source>Pause, %1 s</source>
        <translation>Pause, %1 s</translation>
    </message>
    <message>
        <source>Start posture, arm held still</source>
        <translation>Posture de départ, bras immobile</translation>
    </message>
    <message>
        <source>Entry test of the hand</source>
        <translation>Test d’entrée de la main</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Pull of the fingers on their ties</source>
        <translation>Traction des doigts sur leurs liens</translation>
    </message>
    <message>
        <source>Opening of the hand</source>
        <translation>Ouverture de la main</translation>
    </message>
    <message>
        <source>lets go above</source>
        <translation>se défait au-dessus de</translation>
    </message>
    <message>
        <source>Thumb to index</source>
        <translation>Pouce à index</translation>
    </message>
    <message>
        <source>The hand cannot be drawn: %1.</source>
        <translation>La main ne peut pas être dessinée&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Size of the hand</source>
        <translation>Taille de la main</translation>
    </message>
    <message>
        <source>usual: not measured</source>
        <translation>usuelle&#xa0;: non mesurée</translation>
    </message>
    <message>
        <source>without the hand</source>
        <translation>sans la main</translation>
    </message>
    <message>
        <source>of the other hand</source>
        <translation>de l’autre main</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1&#xa0;: %2, %3</translation>
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
        <translation>Moyenne, %1.</translation>
    </message>
    <message>
        <source>Mean of %1; without a value: %2.</source>
        <translation>Moyenne, %1&#xa0;; sans valeur&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1: choose with the arrow keys (%2)</source>
        <translation>%1&#xa0;: choisir avec les flèches (%2)</translation>
    </message>
    <message>
        <source>single tasks</source>
        <translation>tâches isolées</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nº %1</translation>
    </message>
    <message>
        <source>%1 not completed</source>
        <translation>%1 incomplets</translation>
    </message>
    <message>
        <source>not closed</source>
        <translation>non close</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>zero drifted</source>
        <translation>zéro dérivé</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2)&#xa0;: %3</translation>
    </message>
    <message>
        <source>, simulated</source>
        <translation>, simulé</translation>
    </message>
    <message>
        <source>Grip  –</source>
        <translation>Prise  –</translation>
    </message>
    <message>
        <source>Grip  &lt;b&gt;%1 N&lt;/b&gt;</source>
        <translation>Prise  &lt;b&gt;%1 N&lt;/b&gt;</translation>
    </message>
    <message>
        <source>There is nothing to replay: %1.</source>
        <translation>Il n’y a rien à rejouer&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Thumb</source>
        <translation>Pouce</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Index</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Majeur</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>levels differ</source>
        <translation>niveaux différents</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>version %1</translation>
    </message>
    <message>
        <source>None of its signals can be shown.</source>
        <translation>Aucun de ses signaux ne peut être affiché.</translation>
    </message>
    <message>
        <source>%1 of its %2 channels can be shown.</source>
        <translation>%1 de ses %2 voies peuvent être affichées.</translation>
    </message>
    <message>
        <source>Its first %1 of %2 samples can be shown.</source>
        <translation>Ses %1 premiers échantillons sur %2 peuvent être affichés.</translation>
    </message>
    <message>
        <source>This trial is damaged: %1. %2</source>
        <translation>Cet essai est endommagé&#xa0;: %1. %2</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Manquants</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Maintenus</translation>
    </message>
    <message>
        <source>Beyond range</source>
        <translation>Hors plage</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Non enregistrés</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdus</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>invalides</translation>
    </message>
    <message>
        <source>torn</source>
        <translation>incomplets</translation>
    </message>
    <message>
        <source>late</source>
        <translation>tardifs</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>figés</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>saturés</translation>
    </message>
    <message>
        <source>overloaded</source>
        <translation>surchargés</translation>
    </message>
    <message>
        <source>status errors</source>
        <translation>erreurs d’état</translation>
    </message>
    <message>
        <source>restarts</source>
        <translation>redémarrages</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Bus: %1 frames lost</source>
        <translation>Bus&#xa0;: %1 trames perdues</translation>
    </message>
    <message>
        <source>Sensors and bus</source>
        <translation>Capteurs et bus</translation>
    </message>
    <message>
        <source>nothing to report</source>
        <translation>rien à signaler</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Counts as</source>
        <translation>Compte comme</translation>
    </message>
    <message>
        <source>helped: no assessment</source>
        <translation>aidé&#xa0;: hors bilan</translation>
    </message>
    <message>
        <source>practice: no assessment</source>
        <translation>entraînement&#xa0;: hors bilan</translation>
    </message>
    <message>
        <source>assessment</source>
        <translation>bilan</translation>
    </message>
    <message>
        <source>no assessment</source>
        <translation>hors bilan</translation>
    </message>
    <message>
        <source>Task version</source>
        <translation>Version de la tâche</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>Maximum force</source>
        <translation>Force maximale</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Zéro</translation>
    </message>
    <message>
        <source>none in force</source>
        <translation>aucun en vigueur</translation>
    </message>
    <message>
        <source>Zero drift</source>
        <translation>Dérive du zéro</translation>
    </message>
    <message>
        <source>%1 N: the forces are in doubt</source>
        <translation>%1 N&#xa0;: les forces sont douteuses</translation>
    </message>
    <message>
        <source>not known: no zero followed</source>
        <translation>inconnue&#xa0;: aucune mise à zéro ensuite</translation>
    </message>
    <message>
        <source>Latest frame</source>
        <translation>Trame la plus tardive</translation>
    </message>
    <message>
        <source>%1 ms late</source>
        <translation>%1 ms de retard</translation>
    </message>
    <message>
        <source>EXAMPLE</source>
        <translation>EXEMPLE</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>ENREGISTRÉ</translation>
    </message>
    <message>
        <source>1 trial</source>
        <translation>1 essai</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 essais</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>main droite</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>main gauche</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>entraînement</translation>
    </message>
    <message>
        <source>helped</source>
        <translation>aidé</translation>
    </message>
    <message>
        <source>1 session</source>
        <translation>1 séance</translation>
    </message>
    <message>
        <source>%1 sessions</source>
        <translation>%1 séances</translation>
    </message>
    <message>
        <source>%1: year-month-day; Up and Down change it, Enter adds (%2)</source>
        <translation>%1&#xa0;: jour/mois/année&#xa0;; Haut et Bas le changent, Entrée ajoute (%2)</translation>
    </message>
    <message>
        <source>%1; Enter adds, Ctrl+Z takes back what was typed</source>
        <translation>%1&#xa0;; Entrée ajoute, Ctrl+Z annule la saisie</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Enter)</source>
        <translation>%1 (Ctrl+Entrée)</translation>
    </message>
    <message>
        <source>Removed: %1, %2.</source>
        <translation>Retiré&#xa0;: %1, %2.</translation>
    </message>
    <message>
        <source>This is one session twice: choose another one.</source>
        <translation>C’est deux fois la même séance&#xa0;: choisissez-en une autre.</translation>
    </message>
    <message>
        <source>The two sessions are of different hands.</source>
        <translation>Les deux séances concernent des mains différentes.</translation>
    </message>
    <message>
        <source>The forces of the two sessions come from different sources.</source>
        <translation>Les forces des deux séances viennent de sources différentes.</translation>
    </message>
    <message>
        <source>The two sessions have different frame rates.</source>
        <translation>Les deux séances ont des cadences différentes.</translation>
    </message>
    <message>
        <source>The filter delay of the device differs between the two sessions.</source>
        <translation>Le retard de filtrage de l’appareil diffère entre les deux séances.</translation>
    </message>
    <message>
        <source>other version of the task</source>
        <translation>autre version de la tâche</translation>
    </message>
    <message>
        <source>other parameters or level</source>
        <translation>autres paramètres ou niveau</translation>
    </message>
    <message>
        <source>other object</source>
        <translation>autre objet</translation>
    </message>
    <message>
        <source>%1, %2: other version of the measure</source>
        <translation>%1, %2&#xa0;: autre version de la mesure</translation>
    </message>
    <message>
        <source>Forces and target</source>
        <translation>Forces et cible</translation>
    </message>
    <message>
        <source>Position of the object</source>
        <translation>Position de l’objet</translation>
    </message>
    <message>
        <source>Angle of the object</source>
        <translation>Angle de l’objet</translation>
    </message>
    <message>
        <source>Any recorded channel …</source>
        <translation>Toute voie enregistrée …</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Main gauche</translation>
    </message>
    <message>
        <source>Target of the left hand</source>
        <translation>Cible de la main gauche</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Main droite</translation>
    </message>
    <message>
        <source>Target of the right hand</source>
        <translation>Cible de la main droite</translation>
    </message>
    <message>
        <source>Both hands</source>
        <translation>Les deux mains</translation>
    </message>
    <message>
        <source>Task’s force</source>
        <translation>Force de la tâche</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>cible %1</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>no sample</source>
        <translation>pas d’échantillon</translation>
    </message>
    <message>
        <source>%1 held</source>
        <translation>%1 maintenu</translation>
    </message>
    <message>
        <source>F</source>
        <translation>D</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
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
        <translation>Défaut</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>Reprise</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Aborted</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>lead-in, not scored</source>
        <translation>amorce, non notée</translation>
    </message>
    <message>
        <source>scored</source>
        <translation>noté</translation>
    </message>
    <message>
        <source>transport</source>
        <translation>transport</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>maintien</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
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
        <translation>%1 échantillons écartés</translation>
    </message>
    <message>
        <source>No forces yet</source>
        <translation>Pas encore de forces</translation>
    </message>
    <message>
        <source>   ·   not recorded %1</source>
        <translation>   ·   non enregistrés %1</translation>
    </message>
    <message>
        <source>%1: half within %2 ms, 99 % within %3, 99.9 % within %4, longest %5
</source>
        <translation>%1&#xa0;: la moitié en %2 ms, 99 % en %3, 99,9 % en %4, maximum %5
</translation>
    </message>
    <message>
        <source>From frame to frame</source>
        <translation>D’une trame à l’autre</translation>
    </message>
    <message>
        <source>Late</source>
        <translation>Retard</translation>
    </message>
    <message>
        <source>Work on a frame</source>
        <translation>Calcul d’une trame</translation>
    </message>
    <message>
        <source>Real time was not asked for</source>
        <translation>Le temps réel n’était pas demandé</translation>
    </message>
    <message>
        <source>Acquisition with %1</source>
        <translation>Acquisition avec %1</translation>
    </message>
    <message>
        <source>Push %1 %</source>
        <translation>Poussée %1 %</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>stopped early, kept</source>
        <translation>arrêté avant la fin, conservé</translation>
    </message>
    <message>
        <source>interrupted, kept</source>
        <translation>interrompu, conservé</translation>
    </message>
    <message>
        <source>There is no display for the patient&apos;s screen.</source>
        <translation>Il n’y a pas d’affichage pour l’écran du patient.</translation>
    </message>
    <message>
        <source>The patient&apos;s screen needs OpenGL 2.1: install the driver of the graphics card.</source>
        <translation>L’écran du patient exige OpenGL 2.1&#xa0;: installez le pilote de la carte graphique.</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>pas</translation>
    </message>
    <message>
        <source>Frames with gaps %1   ·   lost %2   ·   damaged %3   ·   late %L4 ms, worst %L5 ms</source>
        <translation>Lacunes %1   ·   perdus %2   ·   abîmés %3   ·   retard %L4 ms, au pire %L5 ms</translation>
    </message>
    <message>
        <source>%1 · %2, %3</source>
        <translation>%1 · %2, %3</translation>
    </message>
    <message>
        <source>%1; stays for the next entry (%2)</source>
        <translation>%1&#xa0;; reste pour l’entrée suivante (%2)</translation>
    </message>
    <message>
        <source>Removed: %1.</source>
        <translation>Retiré&#xa0;: %1.</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>jusqu’au %1</translation>
    </message>
    <message>
        <source>Grip  &lt;b&gt;%1 N, %2 %&lt;/b&gt;</source>
        <translation>Prise  &lt;b&gt;%1 N, %2 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Cannot be judged yet: no assessment yet</source>
        <translation>Pas encore évaluable&#xa0;: aucun bilan</translation>
    </message>
    <message>
        <source>Improved (confirmed) · %1</source>
        <translation>Amélioré (confirmé) · %1</translation>
    </message>
    <message>
        <source>Improved (possible) · %1</source>
        <translation>Amélioré (possible) · %1</translation>
    </message>
    <message>
        <source>Worsened (confirmed) · %1</source>
        <translation>Dégradé (confirmé) · %1</translation>
    </message>
    <message>
        <source>Worsened (possible) · %1</source>
        <translation>Dégradé (possible) · %1</translation>
    </message>
    <message>
        <source>Not larger than measurement error · %1</source>
        <translation>Pas plus grand que l’erreur de mesure · %1</translation>
    </message>
    <message>
        <source>Cannot be judged yet: %1</source>
        <translation>Pas encore évaluable&#xa0;: %1</translation>
    </message>
    <message>
        <source>The measured delay of the display differs between the two sessions.</source>
        <translation>Le retard mesuré de l’affichage diffère entre les deux séances.</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>both hands</source>
        <translation>deux mains</translation>
    </message>
    <message>
        <source>The arm cannot be drawn: %1.</source>
        <translation>Le bras ne peut pas être dessiné&#xa0;: %1.</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>abîmées</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Start posture</source>
        <translation>Posture de départ</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesurée</translation>
    </message>
    <message>
        <source>Angles of the forearm</source>
        <translation>Angles de l’avant-bras</translation>
    </message>
    <message>
        <source>Angles of the wrist</source>
        <translation>Angles du poignet</translation>
    </message>
    <message>
        <source>Angles of the fingers</source>
        <translation>Angles des doigts</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Angle %1</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1&#xa0;cm</translation>
    </message>
    <message>
        <source>Camera on</source>
        <translation>Caméra en marche</translation>
    </message>
</context>
<context>
    <name>Rescue</name>
    <message>
        <source>The database was taken away while these sessions were recorded. They are kept:</source>
        <translation>La base de données a disparu pendant l’enregistrement de ces séances. Elles sont conservées&#xa0;:</translation>
    </message>
    <message>
        <source>Take them in with this command:</source>
        <translation>Cette commande les reprend&#xa0;:</translation>
    </message>
    <message>
        <source>Take them into the database now?</source>
        <translation>Les reprendre maintenant dans la base de données&#xa0;?</translation>
    </message>
</context>
<context>
    <name>ScenePreview</name>
    <message>
        <source>%1 reach the end of the pad</source>
        <translation>%1 atteignent la fin de la pulpe</translation>
    </message>
    <message>
        <source>%1 stop at an edge</source>
        <translation>%1 s’arrêtent à un bord</translation>
    </message>
    <message>
        <source>%1 stop where friction no longer holds</source>
        <translation>%1 s’arrêtent là où le frottement ne tient plus</translation>
    </message>
    <message>
        <source>%1 stop where the surface ends</source>
        <translation>%1 s’arrêtent là où la surface finit</translation>
    </message>
    <message>
        <source>covers %1 of the %2 mm² of the pad</source>
        <translation>couvre %1 des %2 mm² de la pulpe</translation>
    </message>
    <message>
        <source>middle: %1 mm along the tangent, %2 mm across it</source>
        <translation>milieu&#xa0;: %1 mm le long de la tangente, %2 mm en travers</translation>
    </message>
    <message>
        <source>torsion: at most %1 N mm for each newton of pressure, %2 as a pure torque</source>
        <translation>torsion&#xa0;: au plus %1 N mm par newton de pression, %2 en couple pur</translation>
    </message>
    <message>
        <source>of %1 rays: %2</source>
        <translation>sur %1 rayons&#xa0;: %2</translation>
    </message>
    <message>
        <source>Pad: %1</source>
        <translation>Pulpe&#xa0;: %1</translation>
    </message>
    <message>
        <source>no set of fingers</source>
        <translation>aucun groupe de doigts</translation>
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
        <translation>Se déplace</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Tourne</translation>
    </message>
    <message>
        <source>Forces act in</source>
        <translation>Les forces agissent dans</translation>
    </message>
    <message>
        <source>Limits of travel</source>
        <translation>Limites de course</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Grasp rule</source>
        <translation>Règle de prise</translation>
    </message>
    <message>
        <source>Held firmly by</source>
        <translation>Tenu fermement par</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coût de calcul</translation>
    </message>
    <message>
        <source>%1 ns per frame, measured here</source>
        <translation>%1 ns par trame, mesuré ici</translation>
    </message>
    <message>
        <source>press without an object</source>
        <translation>appuient sans objet</translation>
    </message>
    <message>
        <source>press the object with their forces</source>
        <translation>pressent l’objet par leurs forces</translation>
    </message>
    <message>
        <source>are points that forces move</source>
        <translation>sont des points que des forces déplacent</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>main gauche</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>main droite</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left hand</comment>
        <translation>G</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right hand</comment>
        <translation>D</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Two hands</source>
        <translation>Deux mains</translation>
    </message>
</context>
<context>
    <name>Screening</name>
    <message>
        <source>No clearance for maximal effort</source>
        <translation>Effort maximal non autorisé</translation>
    </message>
    <message>
        <source>Injury or inflammation of the hand</source>
        <translation>Lésion, inflammation de la main</translation>
    </message>
    <message>
        <source>Broken or numb skin</source>
        <translation>Peau lésée ou insensible</translation>
    </message>
    <message>
        <source>Botulinum toxin or drug changed</source>
        <translation>Toxine ou traitement modifié</translation>
    </message>
    <message>
        <source>Seizures</source>
        <translation>Crises d’épilepsie</translation>
    </message>
    <message>
        <source>Recent haemorrhage or infarct, unstable heart disease, blood pressure at rest above 180/110, aneurysm, recent eye surgery, or nobody has cleared it</source>
        <translation>Hémorragie ou infarctus récent, cardiopathie instable, tension au repos supérieure à 180/110, anévrisme, chirurgie oculaire récente, ou aucune autorisation</translation>
    </message>
    <message>
        <source>Fracture, tendon repair, wound, acute arthritis, CRPS</source>
        <translation>Fracture, suture tendineuse, plaie, arthrite aiguë, SDRC</translation>
    </message>
    <message>
        <source>Under the straps: wounds, pressure marks, no feeling</source>
        <translation>Sous les sangles&#xa0;: plaies, marques de pression, insensibilité</translation>
    </message>
    <message>
        <source>Since the last session</source>
        <translation>Depuis la dernière séance</translation>
    </message>
    <message>
        <source>In the last year, or known epilepsy</source>
        <translation>Depuis un an, ou épilepsie connue</translation>
    </message>
    <message>
        <source>Look at the straps every 20 minutes.</source>
        <translation>Contrôlez les sangles toutes les 20 minutes.</translation>
    </message>
    <message>
        <source>Mark the treatment on the patient&apos;s page.</source>
        <translation>Notez le traitement sur la page du patient.</translation>
    </message>
    <message>
        <source>Stay beside the patient; the straps open with one hand.</source>
        <translation>Restez près du patient&#xa0;; les sangles s’ouvrent d’une main.</translation>
    </message>
    <message>
        <source>Maximum allowed</source>
        <translation>Maximum autorisé</translation>
    </message>
    <message>
        <source>Comfortable force only</source>
        <translation>Force confortable seulement</translation>
    </message>
    <message>
        <source>No force</source>
        <translation>Aucune force</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>maximum</translation>
    </message>
    <message>
        <source>comfortable</source>
        <translation>confortable</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>aucune force</translation>
    </message>
    <message>
        <source>%1, pain %2</source>
        <translation>%1, douleur %2</translation>
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
        <translation>Cet ordinateur n’a pas de sortie audio&#xa0;: branchez un haut-parleur, puis réessayez.</translation>
    </message>
    <message>
        <source>The sound output does not take 44.1 kHz, 16 bit: choose another one in the settings of the desktop.</source>
        <translation>La sortie audio n’accepte pas 44,1 kHz, 16 bits&#xa0;: choisissez-en une autre dans les réglages du bureau.</translation>
    </message>
    <message>
        <source>This computer has no voice: install speech-dispatcher with a voice such as espeak-ng.</source>
        <translation>Cet ordinateur n’a pas de voix&#xa0;: installez speech-dispatcher avec une voix telle qu’espeak-ng.</translation>
    </message>
    <message>
        <source>The voice of this computer does not speak %1: install one that does.</source>
        <translation>La voix de cet ordinateur ne parle pas %1&#xa0;: installez-en une qui le parle.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::AddDeviceDialog</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 answers. Its camera is looked at in a session only, once a lawful basis is on record.</source>
        <translation>%1 répond. On ne regarde par sa caméra que dans une séance, quand une base légale est enregistrée.</translation>
    </message>
    <message>
        <source>%1. Works: %2 times a second, nothing missing.</source>
        <translation>%1. Fonctionne&#xa0;: %2 fois par seconde, rien ne manque.</translation>
    </message>
    <message>
        <source>%1 answers, but sends nothing whole: look at cables and power.</source>
        <translation>%1 répond, mais n’envoie rien d’entier&#xa0;: vérifiez les câbles et l’alimentation.</translation>
    </message>
    <message>
        <source>%1 answers, but parts are missing in %2 of %3 looks.</source>
        <translation>%1 répond, mais il manque quelque chose dans %2 relevés sur %3.</translation>
    </message>
    <message>
        <source>Add a device</source>
        <translation>Ajouter un appareil</translation>
    </message>
    <message>
        <source>Add the device</source>
        <translation>Ajouter l’appareil</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Ce que c’est</translation>
    </message>
    <message>
        <source>How the device is reached (arrow keys)</source>
        <translation>Comment l’appareil est relié (flèches)</translation>
    </message>
    <message>
        <source>Maker</source>
        <translation>Fabricant</translation>
    </message>
    <message>
        <source>Whose sensors they are (arrow keys)</source>
        <translation>De qui sont les capteurs (flèches)</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Choose or type; empty: Find looks for it (Tab)</source>
        <translation>Choisir ou saisir&#xa0;; vide&#xa0;: Chercher le trouve (Tab)</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Jeu de marqueurs</translation>
    </message>
    <message>
        <source>The file that says how the sensors are mounted and set (arrow keys)</source>
        <translation>Le fichier qui dit comment les capteurs sont montés et réglés (flèches)</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Jeu de marqueurs</translation>
    </message>
    <message>
        <source>What the markers are stuck to (arrow keys)</source>
        <translation>Ce sur quoi les marqueurs sont collés (flèches)</translation>
    </message>
    <message>
        <source>Room 2</source>
        <translation>Salle 2</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>What people here call it (Tab)</source>
        <translation>Comment on l’appelle ici (Tab)</translation>
    </message>
    <message>
        <source>&amp;Find</source>
        <translation>&amp;Chercher</translation>
    </message>
    <message>
        <source>Find what answers</source>
        <translation>Chercher ce qui répond</translation>
    </message>
    <message>
        <source>Asks every place where such a device could be (Alt+F)</source>
        <translation>Interroge tous les endroits où un tel appareil pourrait être (Alt+C)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Vérifier</translation>
    </message>
    <message>
        <source>Check the device</source>
        <translation>Vérifier l’appareil</translation>
    </message>
    <message>
        <source>Opens it, looks at it for a second and lets it go; nothing is recorded (Alt+C)</source>
        <translation>L’ouvre, l’observe une seconde et le relâche&#xa0;; rien n’est enregistré (Alt+V)</translation>
    </message>
    <message>
        <source>Asking</source>
        <translation>Interroge</translation>
    </message>
    <message>
        <source>192.168.1.1: the first of three in a row, or all three</source>
        <translation>192.168.1.1&#xa0;: la première de trois qui se suivent, ou les trois</translation>
    </message>
    <message>
        <source>three ports, with commas</source>
        <translation>trois ports, avec des virgules</translation>
    </message>
    <message>
        <source>as delivered</source>
        <translation>tel que livré</translation>
    </message>
    <message>
        <source>Another device has this name.</source>
        <translation>Un autre appareil porte déjà ce nom.</translation>
    </message>
    <message>
        <source>Asking %1 …</source>
        <translation>Interroge %1 …</translation>
    </message>
    <message>
        <source>Nothing answers. Asked last: %1</source>
        <translation>Rien ne répond. Dernière demande&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ArmPanel</name>
    <message>
        <source>Off by &lt;b&gt;%1&lt;/b&gt;, &lt;b&gt;%2&lt;/b&gt;; %3 mm of it in depth</source>
        <translation>Écart &lt;b&gt;%1&lt;/b&gt;, &lt;b&gt;%2&lt;/b&gt;&#xa0;; dont %3 mm en profondeur</translation>
    </message>
    <message>
        <source>%1 of %2 mm</source>
        <translation>%1 sur %2 mm</translation>
    </message>
    <message>
        <source>%1° of %2°</source>
        <translation>%1° sur %2°</translation>
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
        <translation>Bras en direct</translation>
    </message>
    <message>
        <source>Left arm: targets are those of a right one in the mirror; a screw turns the other way.</source>
        <translation>Bras gauche&#xa0;: les cibles sont celles d’un bras droit dans un miroir&#xa0;; une vis tourne dans l’autre sens.</translation>
    </message>
    <message>
        <source>From the object to its target, beside what counts as there. Depth is along the line of sight: without a second picture for the other eye it is harder to see</source>
        <translation>De l’objet à sa cible, à côté de ce qui compte comme atteint. La profondeur est dans l’axe du regard&#xa0;: sans seconde image pour l’autre œil, elle se voit moins bien</translation>
    </message>
    <message>
        <source>%1: share of the turn</source>
        <translation>%1&#xa0;: part de la rotation</translation>
    </message>
    <message>
        <source>%1: how far it has turned since the target appeared, as a share of all three</source>
        <translation>%1&#xa0;: rotation depuis l’apparition de la cible, en part des trois</translation>
    </message>
    <message>
        <source>The arm is shown once the cameras are connected.</source>
        <translation>Le bras apparaît dès que les caméras sont connectées.</translation>
    </message>
    <message>
        <source>No trial is running.</source>
        <translation>Aucun essai en cours.</translation>
    </message>
    <message>
        <source>The start posture has not been measured yet.</source>
        <translation>La posture de départ n’est pas encore mesurée.</translation>
    </message>
    <message>
        <source>Turned from %1° to %2°, now %3</source>
        <translation>Tourné de %1° à %2°, maintenant %3</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>non vu</translation>
    </message>
    <message>
        <source>The range begins in a moment.</source>
        <translation>L’amplitude commence dans un instant.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2&lt;/b&gt; reached</source>
        <translation>&lt;b&gt;%1 sur %2&lt;/b&gt; atteintes</translation>
    </message>
    <message>
        <source>The object is not seen, or no target is shown.</source>
        <translation>L’objet n’est pas vu, ou aucune cible n’est affichée.</translation>
    </message>
    <message>
        <source>Pictures %1   ·   lost %2   ·   damaged %3   ·   late %L4 ms</source>
        <translation>Images %1   ·   perdues %2   ·   abîmées %3   ·   retard %L4 ms</translation>
    </message>
    <message>
        <source>Practice %1 of %2 on a first visit; bout %3: %4 of %5.</source>
        <translation>Entraînement %1 sur %2 à la première visite&#xa0;; série %3&#xa0;: %4 sur %5.</translation>
    </message>
    <message>
        <source>%1 Last two movements %2 % apart: ✓ enough on a later visit.</source>
        <translation>%1 Deux derniers mouvements à %2 % près&#xa0;: ✓ assez lors d’une visite suivante.</translation>
    </message>
    <message>
        <source>%1 Last two movements %2 % apart: one more on a later visit.</source>
        <translation>%1 Deux derniers mouvements à %2 % près&#xa0;: encore un lors d’une visite suivante.</translation>
    </message>
    <message>
        <source>On a first visit 15 minutes, in bouts of 3 with a rest between them; later until two movements on end differ by less than 10 %, four at most. Practice is work, too</source>
        <translation>À la première visite 15 minutes, par séries de 3 avec un repos entre elles&#xa0;; ensuite jusqu’à ce que deux mouvements de suite diffèrent de moins de 10 %, quatre au plus. L’entraînement est aussi du travail</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ArmScreeningForm</name>
    <message>
        <source>Can do both, no &amp;pain</source>
        <translation>Capable des deux, sans dou&amp;leur</translation>
    </message>
    <message>
        <source>Can do both, no pain, nothing else: own range</source>
        <translation>Capable des deux, pas de douleur, rien d’autre&#xa0;: amplitude propre</translation>
    </message>
    <message>
        <source>No shoulder pain, no contracture, no tape allergy; turns by 10° and holds for 10 s (Alt+P)</source>
        <translation>Ni douleur d’épaule, ni rétraction, ni allergie au ruban&#xa0;; tourne de 10° et tient 10 s (Alt+L)</translation>
    </message>
    <message>
        <source>%1 (Tab, then space)</source>
        <translation>%1 (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Pain now, at rest</source>
        <translation>Douleur actuelle, au repos</translation>
    </message>
    <message>
        <source>Pain now</source>
        <translation>Douleur actuelle</translation>
    </message>
    <message>
        <source>Passive range, as far as measured</source>
        <translation>Amplitude passive, si mesurée</translation>
    </message>
    <message>
        <source>%1: passive range measured</source>
        <translation>%1&#xa0;: amplitude passive mesurée</translation>
    </message>
    <message>
        <source>No target goes beyond this range (Tab, then space)</source>
        <translation>Aucune cible ne dépasse cette amplitude (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>%1, passive, in degrees</source>
        <translation>%1, passive, en degrés</translation>
    </message>
    <message>
        <source>From neutral, thumb up; negative: neutral is not reached (Tab, arrow keys)</source>
        <translation>Depuis la position neutre, pouce en haut&#xa0;; négatif&#xa0;: la position neutre n’est pas atteinte (Tab, flèches)</translation>
    </message>
    <message>
        <source>You decide for this arm</source>
        <translation>Vous décidez pour ce bras</translation>
    </message>
    <message>
        <source>%1 of this arm today (Tab, then space)</source>
        <translation>%1 de ce bras aujourd’hui (Tab, puis Espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ArmViews</name>
    <message>
        <source>The arm from the front, from the side and from above</source>
        <translation>Le bras de face, de côté et de dessus</translation>
    </message>
    <message>
        <source>Markers, the chain from elbow to object, the object (full line) and its target (dashed); one square of the grid is 10 cm</source>
        <translation>Marqueurs, chaîne du coude à l’objet, objet (trait plein) et sa cible (tirets)&#xa0;; un carreau de la grille fait 10 cm</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Dessus</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BackupWork</name>
    <message>
        <source>No backup could be made: %1</source>
        <translation>Aucune sauvegarde n’a pu être faite&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BasisDialog</name>
    <message>
        <source>choose …</source>
        <translation>choisir …</translation>
    </message>
    <message>
        <source>%1 (arrow keys)</source>
        <translation>%1 (touches fléchées)</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Lawful basis</source>
        <translation>Base légale</translation>
    </message>
    <message>
        <source>No camera looks at a person before a lawful basis is on record. Of each purpose the last entry counts; treatment or research must be given.</source>
        <translation>Aucune caméra ne regarde une personne avant qu’une base légale soit enregistrée. Pour chaque finalité, la dernière entrée compte&#xa0;; le traitement ou la recherche doit être accordé.</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Finalité</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Jour</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Enregistré par</translation>
    </message>
    <message>
        <source>What is on record</source>
        <translation>Ce qui est enregistré</translation>
    </message>
    <message>
        <source>In the order in which it was recorded</source>
        <translation>Dans l’ordre de l’enregistrement</translation>
    </message>
    <message>
        <source>Nothing is on record.</source>
        <translation>Rien n’est enregistré.</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>When it was said or signed; Up and Down change it (Tab)</source>
        <translation>Quand cela a été dit ou signé&#xa0;; haut et bas le changent (Tab)</translation>
    </message>
    <message>
        <source>such as the version of the form</source>
        <translation>par exemple la version du formulaire</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Such as the version of the form; may be left empty (Tab)</source>
        <translation>Par exemple la version du formulaire&#xa0;; peut rester vide (Tab)</translation>
    </message>
    <message>
        <source>Give the day on which it was said.</source>
        <translation>Indiquez le jour où cela a été dit.</translation>
    </message>
    <message>
        <source>Adds this entry under your name; it is not changed any more (Enter)</source>
        <translation>Ajoute cette entrée sous votre nom&#xa0;; elle ne change plus (Entrée)</translation>
    </message>
    <message>
        <source>Choose purpose, basis and answer first</source>
        <translation>Choisissez d’abord finalité, base et réponse</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BasisView</name>
    <message>
        <source>Lawful basis …</source>
        <translation>Base légale …</translation>
    </message>
    <message>
        <source>Lawful basis of this person</source>
        <translation>Base légale pour cette personne</translation>
    </message>
    <message>
        <source>Shows what is on record, and records one more entry (Tab, then space)</source>
        <translation>Montre ce qui est enregistré et ajoute une entrée (Tab, puis espace)</translation>
    </message>
    <message>
        <source>Looking for a lawful basis …</source>
        <translation>Recherche d’une base légale …</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>✗ No camera may look at this person: no lawful basis is on record.</source>
        <translation>✗ Aucune caméra ne peut regarder cette personne&#xa0;: aucune base légale n’est enregistrée.</translation>
    </message>
    <message>
        <source>No camera may look at this person:</source>
        <translation>Aucune caméra ne peut regarder cette personne&#xa0;:</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BothHandsPanel</name>
    <message>
        <source>No share: the affected side is not on record.</source>
        <translation>Pas de part&#xa0;: le côté atteint n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Shares are above rest: measure the resting forces first.</source>
        <translation>Les parts sont au-dessus du repos&#xa0;: mesurez d’abord les forces de repos.</translation>
    </message>
    <message>
        <source>Share: both hands rest.</source>
        <translation>Part&#xa0;: les deux mains se reposent.</translation>
    </message>
    <message>
        <source>Share of the affected hand (left) &lt;b&gt;%1 %&lt;/b&gt;</source>
        <translation>Part de la main atteinte (gauche) &lt;b&gt;%1 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Share of the affected hand (right) &lt;b&gt;%1 %&lt;/b&gt;</source>
        <translation>Part de la main atteinte (droite) &lt;b&gt;%1 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 · of effort &lt;b&gt;%2 %&lt;/b&gt;</source>
        <translation>%1 · de l’effort &lt;b&gt;%2 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Live forces of both hands</source>
        <translation>Forces des deux mains en direct</translation>
    </message>
    <message>
        <source>Grip: the smaller of the thumb and the two fingers together; above rest below it</source>
        <translation>Prise&#xa0;: la plus petite valeur entre le pouce et les deux doigts ensemble&#xa0;; dessous, au-dessus du repos</translation>
    </message>
    <message>
        <source>Mean of the last second above each hand&apos;s rest; of effort: each as a part of its maximum. It also rises when the other hand weakens: look at both forces</source>
        <translation>Moyenne de la dernière seconde au-dessus du repos de chaque main&#xa0;; de l’effort&#xa0;: chacune en part de son maximum. Elle augmente aussi quand l’autre main faiblit&#xa0;: regardez les deux forces</translation>
    </message>
    <message>
        <source>Grip forces of the last 20 seconds</source>
        <translation>Forces de prise des 20 dernières secondes</translation>
    </message>
    <message>
        <source>Left L, right R, both L+R, and what is asked of them dashed; the values stand above</source>
        <translation>Gauche G, droite D, les deux G+D, en tirets ce qui est demandé&#xa0;; les valeurs sont au-dessus</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>%1, affected</source>
        <translation>%1, atteinte</translation>
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
        <translation>sur repos %1 N</translation>
    </message>
    <message>
        <source>Left platform: %1</source>
        <translation>Plateforme gauche&#xa0;: %1</translation>
    </message>
    <message>
        <source>Right platform: %1</source>
        <translation>Plateforme droite&#xa0;: %1</translation>
    </message>
    <message>
        <source>Left %1</source>
        <comment>a finger</comment>
        <translation>Gauche, %1</translation>
    </message>
    <message>
        <source>Right %1</source>
        <comment>a finger</comment>
        <translation>Droite, %1</translation>
    </message>
    <message>
        <source>%1 %2 N</source>
        <translation>%1 %2 N</translation>
    </message>
    <message>
        <source>%1, no force yet</source>
        <translation>%1, pas encore de force</translation>
    </message>
    <message>
        <source>lost %1, damaged %2</source>
        <translation>perdus %1, abîmés %2</translation>
    </message>
    <message>
        <source>no forces yet</source>
        <translation>pas encore de forces</translation>
    </message>
    <message>
        <source>No share: the platforms move each other.</source>
        <translation>Pas de part&#xa0;: les plateformes se font bouger.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BothScreeningForm</name>
    <message>
        <source>Left hand</source>
        <translation>Main gauche</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Main droite</translation>
    </message>
    <message>
        <source>✓ %1</source>
        <translation>✓ %1</translation>
    </message>
    <message>
        <source>%1: answered</source>
        <translation>%1&#xa0;: répondu</translation>
    </message>
    <message>
        <source>%1: to be asked</source>
        <translation>%1&#xa0;: à demander</translation>
    </message>
    <message>
        <source>The questions of this hand (Tab, then space)</source>
        <translation>Les questions de cette main (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>For both hands holds: %1.</source>
        <translation>Pour les deux mains vaut&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::CamerasDialog</name>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
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
        <translation>Un enregistrement de marqueurs</translation>
    </message>
    <message>
        <source>System of the cameras</source>
        <translation>Système des caméras</translation>
    </message>
    <message>
        <source>Whose pictures are read (arrow keys)</source>
        <translation>Dont les images sont lues (flèches)</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Choisir …</translation>
    </message>
    <message>
        <source>Choose the recording</source>
        <translation>Choisir l’enregistrement</translation>
    </message>
    <message>
        <source>C3D, TRC, Qualisys table or CSV (Tab)</source>
        <translation>C3D, TRC, table Qualisys ou CSV (Tab)</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Jeu de marqueurs</translation>
    </message>
    <message>
        <source>What the markers are stuck to; docs/markers.md (arrow keys)</source>
        <translation>Où sont collés les marqueurs&#xa0;; docs/markers.md (flèches)</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <source>Use these cameras</source>
        <translation>Utiliser ces caméras</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Open a recording of markers</source>
        <translation>Ouvrir un enregistrement de marqueurs</translation>
    </message>
    <message>
        <source>Markers (*.c3d *.trc *.tsv *.csv);;All files (*)</source>
        <translation>Marqueurs (*.c3d *.trc *.tsv *.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Fichier de l’enregistrement</translation>
    </message>
    <message>
        <source>Address of their computer</source>
        <translation>Adresse de leur ordinateur</translation>
    </message>
    <message>
        <source>Where the recording is (Tab)</source>
        <translation>Où se trouve l’enregistrement (Tab)</translation>
    </message>
    <message>
        <source>Name or number in the network; with :PORT if it is another one (Tab)</source>
        <translation>Nom ou numéro sur le réseau&#xa0;; avec&#xa0;:PORT si c’est un autre (Tab)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ChannelTable</name>
    <message>
        <source>All channels</source>
        <translation>Toutes les voies</translation>
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
        <translation>Force et moment de chaque doigt dans ses axes de contact&#xa0;: z vers l’appui, après la mise à zéro&#xa0;; part du frottement sur l’objet virtuel qui est utilisée (Tab, puis flèches)</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>slips</source>
        <translation>glisse</translation>
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
        <translation>tâches une à une</translation>
    </message>
    <message>
        <source>%1   %2, %3, %4</source>
        <translation>%1   %2, %3, %4</translation>
    </message>
    <message>
        <source>Choose a card to see how somebody is doing.</source>
        <translation>Choisissez une carte pour voir comment va quelqu’un.</translation>
    </message>
    <message>
        <source>No session yet.</source>
        <translation>Pas encore de séance.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ClosingPanel</name>
    <message>
        <source>Effort and pain: not asked yet.</source>
        <translation>Effort et douleur&#xa0;: pas encore demandés.</translation>
    </message>
    <message>
        <source>Effort %1 of 10, pain %2 of 10.</source>
        <translation>Effort %1 sur 10, douleur %2 sur 10.</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Aujourd’hui</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Last time</source>
        <translation>Dernière fois</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changer</translation>
    </message>
    <message>
        <source>Today against last time</source>
        <translation>Aujourd’hui et la dernière fois</translation>
    </message>
    <message>
        <source>Means of today&apos;s trials and of the session before; a verdict of change for the primary measures (Tab, arrow keys)</source>
        <translation>Moyennes des essais d’aujourd’hui et de la séance précédente&#xa0;; pour les mesures principales un verdict de changement (Tab, flèches)</translation>
    </message>
    <message>
        <source>Print for the patient …</source>
        <translation>Imprimer pour le patient …</translation>
    </message>
    <message>
        <source>The page in large letters that the patient takes home (Tab, then Enter)</source>
        <translation>La page en grands caractères que le patient emporte (Tab, puis Entrée)</translation>
    </message>
    <message>
        <source>Report …</source>
        <translation>Rapport …</translation>
    </message>
    <message>
        <source>All of this patient&apos;s report, on its page (Ctrl+R)</source>
        <translation>Tout le rapport sur ce patient, sur sa page (Ctrl+R)</translation>
    </message>
    <message>
        <source>End and next patient</source>
        <translation>Terminer, patient suivant</translation>
    </message>
    <message>
        <source>Ends the session and shows who comes today (F8)</source>
        <translation>Termine la séance et montre qui vient aujourd’hui (F8)</translation>
    </message>
    <message>
        <source>The page for the patient was sent to the printer.</source>
        <translation>La page à emporter a été envoyée à l’imprimante.</translation>
    </message>
    <message>
        <source>The printer takes nothing: is it connected, has it paper?</source>
        <translation>L’imprimante n’accepte rien&#xa0;: est-elle branchée, a-t-elle du papier&#xa0;?</translation>
    </message>
    <message>
        <source>Today: %1, %2</source>
        <translation>Aujourd’hui&#xa0;: %1, %2</translation>
    </message>
    <message>
        <source>Looking at what is stored …</source>
        <translation>Lecture des données enregistrées …</translation>
    </message>
    <message>
        <source>first time</source>
        <translation>première fois</translation>
    </message>
    <message>
        <source>Valid: nothing that was recorded speaks against today&apos;s values.</source>
        <translation>Valable&#xa0;: rien de ce qui a été enregistré ne met en doute les valeurs d’aujourd’hui.</translation>
    </message>
    <message>
        <source>To be kept in mind. %1</source>
        <translation>À garder à l’esprit. %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ComparisonPanel</name>
    <message>
        <source>Compare two sessions</source>
        <translation>Comparer deux séances</translation>
    </message>
    <message>
        <source>Session A</source>
        <translation>Séance A</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>Session B</source>
        <translation>Séance B</translation>
    </message>
    <message>
        <source>F5, then Tab</source>
        <translation>F5, puis Tab</translation>
    </message>
    <message>
        <source>All measures</source>
        <translation>Toutes les mesures</translation>
    </message>
    <message>
        <source>Also those for research, not only those of the report (F5, then Tab twice; Space)</source>
        <translation>Aussi celles de recherche, pas seulement celles du rapport (F5, puis deux fois Tab&#xa0;; Espace)</translation>
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
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Measures of both sessions</source>
        <translation>Mesures des deux séances</translation>
    </message>
    <message>
        <source>Means over the assessments of each session, n of them; up and down arrow keys</source>
        <translation>Moyennes des bilans de chaque séance, au nombre de n&#xa0;; flèches haut et bas</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The two sessions share no assessment.</source>
        <translation>Les deux séances n’ont aucun bilan en commun.</translation>
    </message>
    <message>
        <source>Means over the completed trials without practice and help; n: how many.</source>
        <translation>Moyennes des essais terminés, sans entraînement ni aide&#xa0;; n&#xa0;: leur nombre.</translation>
    </message>
    <message>
        <source>Not compared: %1.</source>
        <translation>Non comparés&#xa0;: %1.</translation>
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
        <translation>Ce qui est présent, patients simulés, enregistrements (Alt+4, puis flèches)</translation>
    </message>
    <message>
        <source>Connecting, or saving the session</source>
        <translation>Connexion, ou enregistrement de la séance</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Finger forces (*.csv);;All files (*)</source>
        <translation>Forces des doigts (*.csv);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Annuler la conne&amp;xion</translation>
    </message>
    <message>
        <source>Cancel connecting</source>
        <translation>Annuler la connexion</translation>
    </message>
    <message>
        <source>Dis&amp;connect</source>
        <translation>Dé&amp;connecter</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>End the session and disconnect (Alt+C)</source>
        <translation>Finir la séance et déconnecter (Alt+C)</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>&amp;Connecter</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Device or cameras</source>
        <translation>Appareil ou caméras</translation>
    </message>
    <message>
        <source>Do not connect (Alt+C)</source>
        <translation>Ne pas connecter (Alt+C)</translation>
    </message>
    <message>
        <source>Begin the session, once the steps above are done (Alt+C)</source>
        <translation>Commencer la séance, une fois les étapes du dessus faites (Alt+C)</translation>
    </message>
    <message>
        <source>Forget this device</source>
        <translation>Oublier cet appareil</translation>
    </message>
    <message>
        <source>Takes what was added here out of the list (Tab, then space)</source>
        <translation>Retire de la liste ce qui a été ajouté ici (Tab, puis espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::CoursePanel</name>
    <message>
        <source>Sessions</source>
        <translation>Séances</translation>
    </message>
    <message>
        <source>Choose a session, newest first: up and down arrow keys (F2)</source>
        <translation>Choisir une séance, la plus récente d’abord&#xa0;: flèches haut et bas (F2)</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Trials of this session</source>
        <translation>Essais de cette séance</translation>
    </message>
    <message>
        <source>Choose a trial with the arrow keys, open it with Enter or the mouse (F3)</source>
        <translation>Choisir un essai avec les flèches, l’ouvrir avec Entrée ou la souris (F3)</translation>
    </message>
    <message>
        <source>Trials of session %1</source>
        <translation>Essais de la séance %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::CrossTalkForm</name>
    <message>
        <source>Press the left platform with at least 20 N for half a second.</source>
        <translation>Appuyez sur la plateforme gauche avec au moins 20 N pendant une demi-seconde.</translation>
    </message>
    <message>
        <source>Now press the right platform with at least 20 N.</source>
        <translation>Appuyez maintenant sur la plateforme droite avec au moins 20 N.</translation>
    </message>
    <message>
        <source>Skipped; this is stored with the session.</source>
        <translation>Passé&#xa0;; c’est enregistré avec la séance.</translation>
    </message>
    <message>
        <source>Do the platforms move each other? Both empty, press one, then the other.</source>
        <translation>Les plateformes se font-elles bouger&#xa0;? Les deux vides&#xa0;: appuyez sur l’une, puis sur l’autre.</translation>
    </message>
    <message>
        <source>They move each other by %1 %: mount them apart. This session has no shares.</source>
        <translation>Elles se font bouger de %1 %&#xa0;: montez-les séparément. Cette séance n’a pas de parts.</translation>
    </message>
    <message>
        <source>✓ They stand apart: %1 % at most.</source>
        <translation>✓ Elles sont séparées&#xa0;: %1 % au plus.</translation>
    </message>
    <message>
        <source>Skip this check</source>
        <translation>Passer cette vérification</translation>
    </message>
    <message>
        <source>Nobody knows then whether one platform moves the other; stored with the session (Tab, then space)</source>
        <translation>On ne sait pas alors si une plateforme fait bouger l’autre&#xa0;; enregistré avec la séance (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Arrêter la vérification</translation>
    </message>
    <message>
        <source>Check the platforms again</source>
        <translation>Vérifier encore les plateformes</translation>
    </message>
    <message>
        <source>Check the platforms</source>
        <translation>Vérifier les plateformes</translation>
    </message>
    <message>
        <source>Each is pressed, empty, with 20 N; the other one may feel 1 % of it (Tab, then space)</source>
        <translation>Chacune est pressée à vide avec 20 N&#xa0;; l’autre peut en sentir 1 % (Tab, puis Espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::DatedList</name>
    <message>
        <source>%1, by date; the arrow keys choose one, Ctrl+Delete removes it</source>
        <translation>%1, par date&#xa0;; les flèches choisissent, Ctrl+Suppr retire</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove the chosen entry</source>
        <translation>Retirer l’entrée choisie</translation>
    </message>
    <message>
        <source>Remove the chosen entry; it can be brought back (Ctrl+Delete)</source>
        <translation>Retirer l’entrée choisie&#xa0;; elle peut être rétablie (Ctrl+Suppr)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Bring back what was removed last</source>
        <translation>Rétablir la dernière entrée retirée</translation>
    </message>
    <message>
        <source>Bring back what was removed last (Ctrl+U)</source>
        <translation>Rétablir la dernière entrée retirée (Ctrl+U)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::DevicePage</name>
    <message>
        <source>not told</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Guided check</source>
        <translation>Vérification guidée</translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation>Résultats de la vérification</translation>
    </message>
    <message>
        <source>One line for every press (Tab, arrow keys)</source>
        <translation>Une ligne par appui (Tab, flèches)</translation>
    </message>
    <message>
        <source>What the sensors counted</source>
        <translation>Comptage des capteurs</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Samples of each sensor</source>
        <translation>Échantillons de chaque capteur</translation>
    </message>
    <message>
        <source>Counted since the device was connected (Tab, arrow keys)</source>
        <translation>Comptés depuis la connexion de l’appareil (Tab, flèches)</translation>
    </message>
    <message>
        <source>Faults in this session</source>
        <translation>Défauts de cette séance</translation>
    </message>
    <message>
        <source>The newest first (Tab, arrow keys)</source>
        <translation>Les plus récents d’abord (Tab, flèches)</translation>
    </message>
    <message>
        <source>None so far.</source>
        <translation>Aucun jusqu’ici.</translation>
    </message>
    <message>
        <source>Stop the chec&amp;k</source>
        <translation>Arrêter la &amp;vérification</translation>
    </message>
    <message>
        <source>Chec&amp;k the supports</source>
        <translation>&amp;Vérifier les appuis</translation>
    </message>
    <message>
        <source>You press each empty support as pictured; swapped sensors, wrong signs and turned axes show (Alt+K)</source>
        <translation>Vous pressez chaque appui vide comme sur l’image&#xa0;; capteurs intervertis, signes faux et axes tournés apparaissent (Alt+V)</translation>
    </message>
    <message>
        <source>Take the hand out, then press each empty support as pictured.</source>
        <translation>Retirez la main, puis pressez chaque appui vide comme sur l’image.</translation>
    </message>
    <message>
        <source>The check needs a connected device and no running trial.</source>
        <translation>La vérification exige un appareil connecté et aucun essai en cours.</translation>
    </message>
    <message>
        <source>Good samples</source>
        <translation>Échantillons valides</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdus</translation>
    </message>
    <message>
        <source>Half samples</source>
        <translation>Échantillons incomplets</translation>
    </message>
    <message>
        <source>Meaningless</source>
        <translation>Sans signification</translation>
    </message>
    <message>
        <source>Standing still</source>
        <translation>Figés</translation>
    </message>
    <message>
        <source>At the end of the range</source>
        <translation>En limite de plage</translation>
    </message>
    <message>
        <source>Overloaded</source>
        <translation>Surchargés</translation>
    </message>
    <message>
        <source>Called wrong by the sensor</source>
        <translation>Signalés faux par le capteur</translation>
    </message>
    <message>
        <source>Set up again</source>
        <translation>Réinitialisés</translation>
    </message>
    <message>
        <source>%1 samples per second, delay %L2 ms</source>
        <translation>%1 échantillons par seconde, retard de %L2 ms</translation>
    </message>
    <message>
        <source>%1: serial number %2, up to %3 N, one count is %L4 N</source>
        <translation>%1&#xa0;: numéro de série %2, jusqu’à %3 N, un pas vaut %L4 N</translation>
    </message>
    <message>
        <source>%L1 min: %2</source>
        <translation>%L1 min&#xa0;: %2</translation>
    </message>
    <message>
        <source>Pictures of the cameras: %1
Lost: %2
Twice: %3
With other markers: %4
Damaged: %5
Connected again: %6</source>
        <translation>Images des caméras&#xa0;: %1
Perdues&#xa0;: %2
En double&#xa0;: %3
Avec d’autres marqueurs&#xa0;: %4
Abîmées&#xa0;: %5
Reconnexions&#xa0;: %6</translation>
    </message>
    <message>
        <source>What the cameras counted</source>
        <translation>Ce que les caméras ont compté</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>A device, or cameras, are chosen and connected on the page of the session, once patient and hand are known.</source>
        <translation>Un appareil, ou des caméras, se choisissent et se connectent sur la page de la séance, une fois le patient et la main connus.</translation>
    </message>
    <message>
        <source>Nothing is connected.</source>
        <translation>Rien n’est connecté.</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Suivi de la main</translation>
    </message>
    <message>
        <source>What the tracker counted</source>
        <translation>Ce que le suivi a compté</translation>
    </message>
    <message>
        <source>Pictures of the tracker: %1
Rows of this hand: %2
Not seen: %3
Of the other hand, not used: %4
Lost: %5
Damaged: %6
Connected again: %7</source>
        <translation>Images du suivi&#xa0;: %1
Lignes de cette main&#xa0;: %2
Non vue&#xa0;: %3
De l’autre main, non utilisées&#xa0;: %4
Perdues&#xa0;: %5
Endommagées&#xa0;: %6
Reconnecté&#xa0;: %7</translation>
    </message>
    <message>
        <source>Platform of the left hand</source>
        <translation>Plateforme de la main gauche</translation>
    </message>
    <message>
        <source>Platform of the right hand</source>
        <translation>Plateforme de la main droite</translation>
    </message>
    <message>
        <source>Platform to be checked</source>
        <translation>Plateforme à vérifier</translation>
    </message>
    <message>
        <source>Which of the two platforms (Tab, arrow keys)</source>
        <translation>Laquelle des deux plateformes (Tab, flèches)</translation>
    </message>
    <message>
        <source>Both platforms</source>
        <translation>Les deux plateformes</translation>
    </message>
    <message>
        <source>left platform, %1</source>
        <translation>plateforme gauche, %1</translation>
    </message>
    <message>
        <source>right platform, %1</source>
        <translation>plateforme droite, %1</translation>
    </message>
    <message>
        <source>What the sensors counted, left / right</source>
        <translation>Ce que les capteurs ont compté, gauche / droite</translation>
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
        <translation>Au repos&#xa0;: la main reste immobile dix secondes.</translation>
    </message>
    <message>
        <source>Now open wide.</source>
        <translation>Maintenant, ouvrez grand.</translation>
    </message>
    <message>
        <source>Now close.</source>
        <translation>Maintenant, fermez.</translation>
    </message>
    <message>
        <source>%1 Opened %2 of %3 times.</source>
        <translation>%1 Ouverte %2 fois sur %3.</translation>
    </message>
    <message>
        <source>Opens %1 mm: objects up to %2 mm are offered.</source>
        <translation>S’ouvre de %1 mm&#xa0;: des objets jusqu’à %2 mm sont proposés.</translation>
    </message>
    <message>
        <source>Entry test</source>
        <translation>Test d’entrée</translation>
    </message>
    <message>
        <source>Entry test: ten seconds at rest, then three openings</source>
        <translation>Test d’entrée&#xa0;: dix secondes de repos, puis trois ouvertures</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Encore une fois</translation>
    </message>
    <message>
        <source>Begin the entry test</source>
        <translation>Commencer le test d’entrée</translation>
    </message>
    <message>
        <source>Ten seconds at rest, then open and close three times: says whether virtual objects are for this hand, and how wide ones (Tab, then space)</source>
        <translation>Dix secondes de repos, puis ouvrir et fermer trois fois&#xa0;: dit si des objets virtuels conviennent à cette main, et de quelle largeur (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>The hand is not seen: bring it before the tracker.</source>
        <translation>La main n’est pas vue&#xa0;: amenez-la devant la caméra.</translation>
    </message>
    <message>
        <source>The hand is seen.</source>
        <translation>La main est vue.</translation>
    </message>
    <message>
        <source>Ten seconds at rest on the table, then open and close three times.</source>
        <translation>Dix secondes de repos sur la table, puis ouvrir et fermer trois fois.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ExportPanel</name>
    <message>
        <source>Exporting …</source>
        <translation>Exportation …</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>Exportation de %1 …</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</source>
        <translation>
            <numerusform>%n essai écrit dans &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</numerusform>
            <numerusform>%n essais écrits dans &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing was written: %1</source>
        <translation>Rien n’a été écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>Annulé&#xa0;: rien n’a été écrit.</translation>
    </message>
    <message>
        <source>Research export</source>
        <translation>Export de recherche</translation>
    </message>
    <message>
        <source>Whose data</source>
        <translation>Données de qui</translation>
    </message>
    <message>
        <source>The chosen patient or all (Alt+W, then arrow keys)</source>
        <translation>Le patient choisi ou tous (Alt+Q, puis flèches)</translation>
    </message>
    <message>
        <source>The chosen patient</source>
        <translation>Le patient choisi</translation>
    </message>
    <message>
        <source>All patients</source>
        <translation>Tous les patients</translation>
    </message>
    <message>
        <source>F&amp;irst session</source>
        <translation>&amp;Première séance</translation>
    </message>
    <message>
        <source>L&amp;ast session</source>
        <translation>Der&amp;nière séance</translation>
    </message>
    <message>
        <source>Format of the export</source>
        <translation>Format de l’export</translation>
    </message>
    <message>
        <source>How signals and measures are written (Alt+N, then arrow keys)</source>
        <translation>Comment signaux et mesures sont écrits (Alt+M, puis flèches)</translation>
    </message>
    <message>
        <source>Tables: CSV and JSON</source>
        <translation>Tableaux&#xa0;: CSV et JSON</translation>
    </message>
    <message>
        <source>One file: HDF5</source>
        <translation>Un seul fichier&#xa0;: HDF5</translation>
    </message>
    <message>
        <source>Data set: Motion-BIDS</source>
        <translation>Jeu de données&#xa0;: Motion-BIDS</translation>
    </message>
    <message>
        <source>Health record: HL7 FHIR</source>
        <translation>Dossier de santé&#xa0;: HL7 FHIR</translation>
    </message>
    <message>
        <source>Codes only: no names, dates, notes or addresses of devices are written.</source>
        <translation>Codes seulement&#xa0;: ni noms, ni dates, ni notes, ni adresses d’appareils.</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>E&amp;xporter …</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Into a new folder; nothing is overwritten, not during a trial (Alt+E)</source>
        <translation>Dans un nouveau dossier&#xa0;; rien n’est écrasé, pas pendant un essai (Alt+X)</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Avancement de l’export</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Ann&amp;uler</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>Annuler l’export</translation>
    </message>
    <message>
        <source>Nothing of it is kept (Alt+C)</source>
        <translation>Rien n’en est conservé (Alt+U)</translation>
    </message>
    <message>
        <source>&amp;Whose data</source>
        <translation>Données de &amp;qui</translation>
    </message>
    <message>
        <source>Form of the &amp;numbers</source>
        <translation>For&amp;me des nombres</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Ce qui sera écrit</translation>
    </message>
    <message>
        <source>Files that will be written</source>
        <translation>Fichiers qui seront écrits</translation>
    </message>
    <message>
        <source>Numbers only (Tab, arrow keys)</source>
        <translation>Des nombres seulement (Tab, flèches)</translation>
    </message>
    <message>
        <source>A folder for the export</source>
        <translation>Un dossier pour l’export</translation>
    </message>
    <message>
        <source>Choose a patient on the start page, or all.</source>
        <translation>Choisissez un patient sur la page d’accueil, ou tous.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s), below a new folder:</source>
        <translation>
            <numerusform>%n fichier, dans un nouveau dossier&#xa0;:</numerusform>
            <numerusform>%n fichiers, dans un nouveau dossier&#xa0;:</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is stored yet.</source>
        <translation>Rien n’est encore enregistré.</translation>
    </message>
    <message>
        <source>Waits for the end of the trial</source>
        <translation>Attend la fin de l’essai</translation>
    </message>
    <message numerus="yes">
        <source>%n patient(s) left out: not released for research.</source>
        <translation>
            <numerusform>%n personne laissée de côté&#xa0;: non autorisée pour la recherche.</numerusform>
            <numerusform>%n personnes laissées de côté&#xa0;: non autorisées pour la recherche.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::FaultCard</name>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>What has failed (F8)</source>
        <translation>Ce qui a échoué (F8)</translation>
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
        <translation>un autre programme</translation>
    </message>
    <message>
        <source>This file is open in another window</source>
        <translation>Ce fichier est ouvert dans une autre fenêtre</translation>
    </message>
    <message>
        <source>%1&lt;br&gt;is open: %2.&lt;br&gt;&lt;br&gt;Two windows must not change the same records. Look at them here, work in the other window, or open another file.</source>
        <translation>%1&lt;br&gt;est ouvert&#xa0;: %2.&lt;br&gt;&lt;br&gt;Deux fenêtres ne doivent pas modifier les mêmes données. Consultez-les ici, travaillez dans l’autre fenêtre, ou ouvrez un autre fichier.</translation>
    </message>
    <message>
        <source>&amp;Look only</source>
        <translation>&amp;Consulter seulement</translation>
    </message>
    <message>
        <source>Courses and reports are shown; nothing is changed (Alt+L)</source>
        <translation>Les évolutions et les rapports sont montrés&#xa0;; rien n’est modifié (Alt+L)</translation>
    </message>
    <message>
        <source>&amp;Open another file …</source>
        <translation>&amp;Ouvrir un autre fichier…</translation>
    </message>
    <message>
        <source>Choose another database (Alt+O)</source>
        <translation>Choisir une autre base de données (Alt+O)</translation>
    </message>
    <message>
        <source>L&amp;eave</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Open nothing (Alt+E, Escape)</source>
        <translation>Ne rien ouvrir (Alt+E, Échap)</translation>
    </message>
    <message>
        <source>Open another file</source>
        <translation>Ouvrir un autre fichier</translation>
    </message>
    <message>
        <source>Databases (*.db);;All files (*)</source>
        <translation>Bases de données (*.db);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::FingerBar</name>
    <message>
        <source>%1: normal force, pressing is positive</source>
        <translation>%1&#xa0;: force normale, positive en appui</translation>
    </message>
    <message>
        <source>%1, no force yet</source>
        <translation>%1, pas encore de force</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manquant</translation>
    </message>
    <message>
        <source>overload</source>
        <translation>surcharge</translation>
    </message>
    <message>
        <source>at its limit</source>
        <translation>en limite</translation>
    </message>
    <message>
        <source>held</source>
        <translation>maintenu</translation>
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
        <translation>Première &amp;visite d’abord</translation>
    </message>
    <message>
        <source>Choose the protocol of a first visit</source>
        <translation>Choisir le protocole d’une première visite</translation>
    </message>
    <message>
        <source>It begins with practice in bouts (Alt+V)</source>
        <translation>Il commence par un entraînement par séries (Alt+V)</translation>
    </message>
    <message>
        <source>This arm has not worked with the cameras before. “%1” begins with %2 minutes of practice.</source>
        <translation>Ce bras n’a pas encore travaillé avec les caméras. « %1 » commence par %2 minutes d’entraînement.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::GraspView</name>
    <message>
        <source>Hold, weakest direction (G min)</source>
        <translation>Tenue, direction la plus faible (G min)</translation>
    </message>
    <message>
        <source>Hand, weakest direction (H min)</source>
        <translation>Main, direction la plus faible (H min)</translation>
    </message>
    <message>
        <source>Hand, on the whole (H det)</source>
        <translation>Main, dans l’ensemble (H det)</translation>
    </message>
    <message>
        <source>%1: pull</source>
        <translation>%1&#xa0;: traction</translation>
    </message>
    <message>
        <source>%1: how hard it pulls away, as a share of the pull at which its tie lets go</source>
        <translation>%1&#xa0;: force avec laquelle il s’éloigne, en part de la traction où le lien lâche</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 of %2 N</source>
        <translation>%1 sur %2 N</translation>
    </message>
    <message>
        <source>Grasp: no object is there.</source>
        <translation>Prise&#xa0;: aucun objet.</translation>
    </message>
    <message>
        <source>Grasp: fewer than two fingers touch.</source>
        <translation>Prise&#xa0;: moins de deux doigts touchent.</translation>
    </message>
    <message>
        <source>Grasp: ✓ it holds, and may be helped.</source>
        <translation>Prise&#xa0;: ✓ elle tient et peut être aidée.</translation>
    </message>
    <message>
        <source>Grasp: ✗ only the help holds it.</source>
        <translation>Prise&#xa0;: ✗ seule l’aide la tient.</translation>
    </message>
    <message>
        <source>Grasp: ✗ it does not hold yet.</source>
        <translation>Prise&#xa0;: ✗ elle ne tient pas encore.</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>plus de %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HandPanel</name>
    <message>
        <source>Counting the pictures of the tracker …</source>
        <translation>Comptage des images du suivi …</translation>
    </message>
    <message>
        <source>Live hand</source>
        <translation>Main en direct</translation>
    </message>
    <message>
        <source>Let the object go</source>
        <translation>Lâcher l’objet</translation>
    </message>
    <message>
        <source>The object falls through the hand; the placement ends as helped, which is no drop (Ctrl+O)</source>
        <translation>L’objet tombe à travers la main&#xa0;; le placement finit avec aide, ce n’est pas une chute (Ctrl+O)</translation>
    </message>
    <message>
        <source>● Camera on</source>
        <translation>● Caméra active</translation>
    </message>
    <message>
        <source>A camera looks at the person until the session ends. No picture is read or stored</source>
        <translation>Une caméra voit la personne jusqu’à la fin de la séance. Aucune image n’est lue ni enregistrée</translation>
    </message>
    <message>
        <source>The hand is shown once the tracker is connected.</source>
        <translation>La main apparaît dès que le suivi est connecté.</translation>
    </message>
    <message>
        <source>The hand is not seen.</source>
        <translation>La main n’est pas vue.</translation>
    </message>
    <message>
        <source>Thumb and index %1 mm apart.</source>
        <translation>Pouce et index écartés de %1 mm.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2&lt;/b&gt; done</source>
        <translation>&lt;b&gt;%1 sur %2&lt;/b&gt; faits</translation>
    </message>
    <message>
        <source>No trial is running.</source>
        <translation>Aucun essai n’est en cours.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2&lt;/b&gt; placed · placement %3 · help: &lt;b&gt;%4&lt;/b&gt; · drops &lt;b&gt;%5&lt;/b&gt;</source>
        <translation>&lt;b&gt;%1 sur %2&lt;/b&gt; posés · placement %3 · aide&#xa0;: &lt;b&gt;%4&lt;/b&gt; · chutes&#xa0;: &lt;b&gt;%5&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 · eased</source>
        <translation>%1 · facilité</translation>
    </message>
    <message>
        <source>%1 · &lt;b&gt;let go for the hand&lt;/b&gt;</source>
        <translation>%1 · &lt;b&gt;lâché pour la main&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 · &lt;b&gt;the hand is to open&lt;/b&gt;</source>
        <translation>%1 · &lt;b&gt;la main doit s’ouvrir&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 Virtual hand %2 mm from the tracked one.</source>
        <translation>%1 Main virtuelle à %2 mm de la main suivie.</translation>
    </message>
    <message>
        <source>%1 pictures a second · %2 % of the last 10 s not seen · times lost: %3</source>
        <translation>%1 images par seconde · %2 % des 10 dernières s non vues · perdue, fois&#xa0;: %3</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HandScreeningForm</name>
    <message>
        <source>Nothing applies, no pain: the hand may move</source>
        <translation>Rien ne s’applique, pas de douleur&#xa0;: la main peut bouger</translation>
    </message>
    <message>
        <source>None of the reasons below, no pain, forearm as ticked (Alt+P)</source>
        <translation>Aucune des raisons ci-dessous, pas de douleur, avant-bras comme coché (Alt+L)</translation>
    </message>
    <message>
        <source>%1 (Tab, then space)</source>
        <translation>%1 (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Pain now, at rest</source>
        <translation>Douleur actuelle, au repos</translation>
    </message>
    <message>
        <source>Pain now</source>
        <translation>Douleur actuelle</translation>
    </message>
    <message>
        <source>Forearm supported</source>
        <translation>Avant-bras soutenu</translation>
    </message>
    <message>
        <source>It lies on the table or a rest while the hand works; stored with the session (Tab, then space)</source>
        <translation>Il repose sur la table ou un appui pendant que la main travaille&#xa0;; enregistré avec la séance (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>You decide for this hand</source>
        <translation>Votre décision pour cette main</translation>
    </message>
    <message>
        <source>%1: this hand, today (Tab, then space)</source>
        <translation>%1&#xa0;: cette main, aujourd’hui (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>It may move</source>
        <translation>Elle peut bouger</translation>
    </message>
    <message>
        <source>No movement</source>
        <translation>Pas de mouvement</translation>
    </message>
    <message>
        <source>Nothing applies, no &amp;pain</source>
        <translation>Rien à signaler, pas de dou&amp;leur</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HandsPlot</name>
    <message>
        <source>Time before now (s)</source>
        <translation>Temps avant maintenant (s)</translation>
    </message>
    <message>
        <source>Grip force (N)</source>
        <translation>Force de prise (N)</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left hand, at the end of its curve</comment>
        <translation>G</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right hand, at the end of its curve</comment>
        <translation>D</translation>
    </message>
    <message>
        <source>L+R</source>
        <comment>both hands, at the end of their curve</comment>
        <translation>G+D</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::HistoryPanel</name>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Historique</translation>
    </message>
    <message>
        <source>Task and measure</source>
        <translation>Tâche et mesure</translation>
    </message>
    <message>
        <source>Which measure of the patient is shown (Alt+H)</source>
        <translation>Quelle mesure du patient est affichée (Alt+H)</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Stored values</source>
        <translation>Valeurs enregistrées</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Évolution</translation>
    </message>
    <message>
        <source>The same values in order; hollow dots are practice trials</source>
        <translation>Les mêmes valeurs dans l’ordre&#xa0;; points creux&#xa0;: entraînement</translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1, entraînement</translation>
    </message>
    <message>
        <source>Choose a patient to see what is stored.</source>
        <translation>Choisissez un patient pour voir ses données.</translation>
    </message>
    <message>
        <source>Reading what is stored …</source>
        <translation>Lecture des données …</translation>
    </message>
    <message>
        <source>Nothing stored for this patient yet.</source>
        <translation>Rien n’est encore enregistré pour ce patient.</translation>
    </message>
    <message>
        <source>Every stored value of this measure (Tab, arrow keys)</source>
        <translation>Toutes les valeurs enregistrées de cette mesure (Tab, flèches)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::IdentityCard</name>
    <message>
        <source>Identity</source>
        <translation>Identité</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Encrypted (Tab)</source>
        <translation>Chiffré (Tab)</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Né(e) le</translation>
    </message>
    <message>
        <source>Date of birth, encrypted (Tab)</source>
        <translation>Date de naissance, chiffrée (Tab)</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Show the identit&amp;y</source>
        <translation>Montrer l’&amp;identité</translation>
    </message>
    <message>
        <source>Show the identity</source>
        <translation>Montrer l’identité</translation>
    </message>
    <message>
        <source>Who this code is; the audit log says who looked (Alt+Y)</source>
        <translation>Qui est ce code&#xa0;; le journal dit qui a regardé (Alt+Y)</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Conserver</translation>
    </message>
    <message>
        <source>Keep the identity</source>
        <translation>Conserver l’identité</translation>
    </message>
    <message>
        <source>Encrypted, apart from everything that was measured (Alt+K)</source>
        <translation>Chiffré, séparé de tout ce qui a été mesuré (Alt+K)</translation>
    </message>
    <message>
        <source>Nothing is known of this person yet.</source>
        <translation>On ne sait encore rien de cette personne.</translation>
    </message>
    <message>
        <source>Kept.</source>
        <translation>Conservé.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LibraryPage</name>
    <message>
        <source>Library</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <source>&amp;Tasks</source>
        <translation>&amp;Tâches</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>What the patient is asked to do (Alt+T)</source>
        <translation>Ce qui est demandé au patient (Alt+T)</translation>
    </message>
    <message>
        <source>&amp;Scenes</source>
        <translation>&amp;Scènes</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Scènes</translation>
    </message>
    <message>
        <source>Objects that a task can have (Alt+S)</source>
        <translation>Objets qu’une tâche peut avoir (Alt+S)</translation>
    </message>
    <message>
        <source>&amp;Protocols</source>
        <translation>&amp;Protocoles</translation>
    </message>
    <message>
        <source>Protocols</source>
        <translation>Protocoles</translation>
    </message>
    <message>
        <source>What sessions consist of (Alt+P)</source>
        <translation>Ce dont les séances se composent (Alt+P)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Search the library</source>
        <translation>Chercher dans les modèles</translation>
    </message>
    <message>
        <source>Any part of the name or of the file (Alt+F)</source>
        <translation>Une partie du nom ou du fichier (Alt+F)</translation>
    </message>
    <message>
        <source>Files of the library</source>
        <translation>Fichiers des modèles</translation>
    </message>
    <message>
        <source>Arrow keys choose one, Enter goes to its text (Alt+I)</source>
        <translation>Les flèches en choisissent un, Entrée va à son texte (Alt+I)</translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation>Ré&amp;cupérer</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>The file that was removed last (Alt+B)</source>
        <translation>Le dernier fichier retiré (Alt+C)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>An own file with this text under a new name (Alt+D)</source>
        <translation>Un fichier à vous avec ce texte, sous un nouveau nom (Alt+D)</translation>
    </message>
    <message>
        <source>Sa&amp;ve</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Sessions use it from now on; what a stored trial used is kept (Ctrl+S)</source>
        <translation>Les séances l’utilisent désormais&#xa0;; ce qu’un essai enregistré a utilisé est conservé (Ctrl+S)</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>Re&amp;venir</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>What was saved last; Undo brings your text back (Alt+R)</source>
        <translation>Au dernier texte enregistré&#xa0;; Annuler ramène le vôtre (Alt+V)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Retirer</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Puts this own file away; it can be brought back (Alt+M)</source>
        <translation>Met de côté ce fichier à vous&#xa0;; il peut être récupéré (Alt+R)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>Annuler (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Shift+Z)</source>
        <translation>Rétablir (Ctrl+Maj+Z)</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>Texte du fichier</translation>
    </message>
    <message>
        <source>Ctrl+Z undoes, Ctrl+Shift+Z redoes; Tab leaves the text (Alt+X)</source>
        <translation>Ctrl+Z annule, Ctrl+Maj+Z rétablit&#xa0;; Tab quitte le texte (Alt+X)</translation>
    </message>
    <message>
        <source>&amp;Go to line</source>
        <translation>À la &amp;ligne</translation>
    </message>
    <message>
        <source>Go to the line of the problem</source>
        <translation>Aller à la ligne du problème</translation>
    </message>
    <message>
        <source>The cursor to the line that the reader refuses (Alt+G)</source>
        <translation>Le curseur à la ligne qui ne peut pas être lue (Alt+L)</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Les vôtres</translation>
    </message>
    <message>
        <source>Shipped, read-only</source>
        <translation>Fournis, en lecture seule</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>inutilisable</translation>
    </message>
    <message>
        <source>has unsaved changes</source>
        <translation>avec des modifications non enregistrées</translation>
    </message>
    <message>
        <source>Choose a file.</source>
        <translation>Choisissez un fichier.</translation>
    </message>
    <message>
        <source>%1 – not saved</source>
        <translation>%1 – non enregistré</translation>
    </message>
    <message>
        <source>Shipped: it stays as it is. Duplicate it to change it.</source>
        <translation>Fourni&#xa0;: il reste tel quel. Dupliquez-le pour le modifier.</translation>
    </message>
    <message>
        <source>&amp;Bring back: %1</source>
        <translation>Ré&amp;cupérer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Your unsaved changes are here again. Revert takes them back.</source>
        <translation>Vos modifications non enregistrées sont de nouveau là. «&#xa0;Revenir&#xa0;» les annule.</translation>
    </message>
    <message>
        <source>✓ It can be used.</source>
        <translation>✓ Utilisable.</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, ligne %1</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>Non conservé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Non enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not saved: the database is not open, so that nobody knows what trials used.</source>
        <translation>Non enregistré&#xa0;: la base de données n’est pas ouverte&#xa0;; on ignore donc ce que les essais ont utilisé.</translation>
    </message>
    <message>
        <source>Saved as version %1: trials were recorded with the former text, which is kept.</source>
        <translation>Enregistré comme version %1&#xa0;: des essais ont été enregistrés avec l’ancien texte, qui est conservé.</translation>
    </message>
    <message>
        <source>Saved. The former text was used and is kept as %1.</source>
        <translation>Enregistré. L’ancien texte a servi et est conservé sous %1.</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Enregistré.</translation>
    </message>
    <message>
        <source>P&amp;ostures</source>
        <translation>P&amp;ostures</translation>
    </message>
    <message>
        <source>Postures</source>
        <translation>Postures</translation>
    </message>
    <message>
        <source>What an arm is asked to do with an object (Alt+O)</source>
        <translation>Où un bras doit amener un objet (Alt+O)</translation>
    </message>
    <message>
        <source>Saved. Trials were recorded with the former postures, which are kept as %1: with these a new series begins.</source>
        <translation>Enregistré. Des essais ont été enregistrés avec les postures d’avant, conservées sous&#xa0;%1&#xa0;: avec celles-ci commence une nouvelle série.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LibraryView</name>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Of the last text that could be read.</source>
        <translation>Du dernier texte lisible.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Habituel</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Steps of the protocol with their durations</source>
        <translation>Étapes du protocole avec leur durée</translation>
    </message>
    <message>
        <source>What it consists of and how long each step takes, in minutes and seconds (Tab, arrow keys)</source>
        <translation>Ce dont il se compose et la durée de chaque étape, en minutes et secondes (Tab, flèches)</translation>
    </message>
    <message>
        <source>What it is, in words</source>
        <translation>Ce que c’est, en mots</translation>
    </message>
    <message>
        <source>Durations, what must be measured before, the plan of an object (Tab, arrow keys)</source>
        <translation>Durées, ce qui doit être mesuré avant, le plan d’un objet (Tab, flèches)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LivePanel</name>
    <message>
        <source>Live forces</source>
        <translation>Forces en direct</translation>
    </message>
    <message>
        <source>Grip: the smaller of the thumb and the two fingers together. Push: what the whole hand pushes the platform, in % of the grip; from 20 % on arm or trunk take part</source>
        <translation>Prise&#xa0;: la plus petite valeur entre le pouce et les deux doigts ensemble. Poussée&#xa0;: ce que toute la main exerce sur la plateforme, en % de la prise&#xa0;; à partir de 20 %, le bras ou le tronc participent</translation>
    </message>
    <message>
        <source>Forces of the last 20 seconds</source>
        <translation>Forces des 20 dernières secondes</translation>
    </message>
    <message>
        <source>Thumb T, index I, middle M, and the target dashed; the values stand above</source>
        <translation>Pouce P, index I, majeur M, et la cible en pointillé&#xa0;; les valeurs sont au-dessus</translation>
    </message>
    <message>
        <source>Health of the stream: gaps are bridged for at most 50 ms, then the trial waits.
</source>
        <translation>État du flux&#xa0;: les lacunes sont comblées pendant 50 ms au plus, puis l’essai attend.
</translation>
    </message>
    <message>
        <source>%1 %2 N</source>
        <translation>%1 %2 N</translation>
    </message>
    <message>
        <source>%1, no force yet</source>
        <translation>%1, pas encore de force</translation>
    </message>
    <message>
        <source>All channels</source>
        <translation>Toutes les voies</translation>
    </message>
    <message>
        <source>All eighteen forces and moments in numbers (Ctrl+L)</source>
        <translation>Les dix-huit forces et moments en chiffres (Ctrl+L)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LivePlot</name>
    <message>
        <source>Time before now (s)</source>
        <translation>Temps avant maintenant (s)</translation>
    </message>
    <message>
        <source>Normal force (N)</source>
        <translation>Force normale (N)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::LoginPage</name>
    <message>
        <source>Who are you?</source>
        <translation>Qui êtes-vous&#xa0;?</translation>
    </message>
    <message>
        <source>Your account (Alt+W, then arrow keys)</source>
        <translation>Votre compte (Alt+Q, puis flèches)</translation>
    </message>
    <message>
        <source>&amp;Who are you?</source>
        <translation>&amp;Qui êtes-vous&#xa0;?</translation>
    </message>
    <message>
        <source>With the &amp;password instead</source>
        <translation>Plutôt avec le mot de &amp;passe</translation>
    </message>
    <message>
        <source>With the password instead</source>
        <translation>Plutôt avec le mot de passe</translation>
    </message>
    <message>
        <source>For somebody without a PIN, or after three wrong ones (Alt+P)</source>
        <translation>Pour quelqu’un sans PIN, ou après trois faux (Alt+P)</translation>
    </message>
    <message>
        <source>&amp;Log in</source>
        <translation>Se &amp;connecter</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Se connecter</translation>
    </message>
    <message>
        <source>Who logs in stands in the record of every act (Enter)</source>
        <translation>Qui se connecte figure au journal de chaque acte (Entrée)</translation>
    </message>
    <message>
        <source>The clinic&apos;s passphrase</source>
        <translation>La phrase secrète de la clinique</translation>
    </message>
    <message>
        <source>The recovery key</source>
        <translation>La clé de secours</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>This database is protected</source>
        <translation>Cette base de données est protégée</translation>
    </message>
    <message>
        <source>Nobody has touched anything for a while, or somebody has locked it. A session that is open goes on behind this page.</source>
        <translation>Personne n’a rien touché depuis un moment, ou quelqu’un a verrouillé. Une séance ouverte continue derrière cette page.</translation>
    </message>
    <message>
        <source>Names, notes and goals are encrypted. Log in to open it.</source>
        <translation>Noms, notes et objectifs sont chiffrés. Connectez-vous pour les ouvrir.</translation>
    </message>
    <message>
        <source>Pa&amp;ssword or phrase</source>
        <translation>&amp;Mot de passe ou phrase</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>Passphrase of the &amp;clinic</source>
        <translation>P&amp;hrase secrète de la clinique</translation>
    </message>
    <message>
        <source>Recover&amp;y key, as it was printed</source>
        <translation>Cl&amp;é de secours, comme imprimée</translation>
    </message>
    <message>
        <source>%1 (Enter logs in)</source>
        <translation>%1 (Entrée connecte)</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Un instant …</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::MarkerTable</name>
    <message>
        <source>Marker</source>
        <translation>Marqueur</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Vu</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Résidu</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Segments and markers</source>
        <translation>Segments et marqueurs</translation>
    </message>
    <message>
        <source>How much of the last 10 seconds each was seen, by how much its markers miss it, and what the newest picture shows (Tab, then arrow keys)</source>
        <translation>Part des 10 dernières secondes où chacun a été vu, écart de ses marqueurs, et ce que montre la dernière image (Tab, puis flèches)</translation>
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
        <translation>Choisir un patient</translation>
    </message>
    <message>
        <source>Choose the arm</source>
        <translation>Choisir le bras</translation>
    </message>
    <message>
        <source>Choose the hand</source>
        <translation>Choisir la main</translation>
    </message>
    <message>
        <source>Answer the screening</source>
        <translation>Répondre aux questions</translation>
    </message>
    <message>
        <source>Go on or anew?</source>
        <translation>Continuer ou recommencer&#xa0;?</translation>
    </message>
    <message>
        <source>Choose the device</source>
        <translation>Choisir l’appareil</translation>
    </message>
    <message>
        <source>The state of the session and the sensible next step</source>
        <translation>L’état de la séance et l’étape suivante utile</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop the trial</source>
        <translation>Arrêter l’essai</translation>
    </message>
    <message>
        <source>End the trial now; it is kept and marked (F10)</source>
        <translation>Finir l’essai maintenant&#xa0;; il est conservé et marqué (F10)</translation>
    </message>
    <message>
        <source>The next thing to do (F8)</source>
        <translation>La prochaine chose à faire (F8)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ObjectPathView</name>
    <message>
        <source>From the front</source>
        <translation>De face</translation>
    </message>
    <message>
        <source>From the right</source>
        <translation>De droite</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ObjectSketch</name>
    <message numerus="yes">
        <source>The object in the plane of x and y, with %n target(s)</source>
        <translation>
            <numerusform>L’objet dans le plan de x et y, avec %n cible</numerusform>
            <numerusform>L’objet dans le plan de x et y, avec %n cibles</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>x to the right, y up; arrows: fingers or hands, and where they press; outlines: targets in their order, dashed: where an object appears</source>
        <translation>x vers la droite, y vers le haut&#xa0;; flèches&#xa0;: doigts ou mains, et où ils appuient&#xa0;; contours&#xa0;: cibles dans leur ordre, en pointillé&#xa0;: où un objet apparaît</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::OpenSessionStrip</name>
    <message>
        <source>&amp;Go to it</source>
        <translation>&amp;Y aller</translation>
    </message>
    <message>
        <source>Go to the open session</source>
        <translation>Aller à la séance ouverte</translation>
    </message>
    <message>
        <source>Alt+G</source>
        <translation>Alt+Y</translation>
    </message>
    <message>
        <source>&amp;End it</source>
        <translation>T&amp;erminer</translation>
    </message>
    <message>
        <source>End the open session</source>
        <translation>Terminer la séance ouverte</translation>
    </message>
    <message>
        <source>All that was measured is kept; a trial that stands still is ended and marked (Alt+E)</source>
        <translation>Tout ce qui a été mesuré est conservé&#xa0;; un essai arrêté est terminé et marqué (Alt+E)</translation>
    </message>
    <message>
        <source>The session of %1, %2, is open since %3.</source>
        <translation>La séance de %1, %2, est ouverte depuis %3.</translation>
    </message>
    <message>
        <source>%1 A trial runs.</source>
        <translation>%1 Un essai est en cours.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::OtherHandButton</name>
    <message>
        <source>Now the left arm</source>
        <translation>Maintenant le bras gauche</translation>
    </message>
    <message>
        <source>Now the right arm</source>
        <translation>Maintenant le bras droit</translation>
    </message>
    <message>
        <source>Now the left hand</source>
        <translation>Maintenant la main gauche</translation>
    </message>
    <message>
        <source>Now the right hand</source>
        <translation>Maintenant la main droite</translation>
    </message>
    <message>
        <source>What was done is kept; screening, zero and straps are asked anew, the device stays chosen (Tab, then space)</source>
        <translation>Ce qui est fait est conservé&#xa0;; les questions de sécurité, le zéro et les sangles sont redemandés, l’appareil reste choisi (Tab, puis espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatchSketch</name>
    <message>
        <source>What the pads cover of the object: %1</source>
        <translation>Ce que les pulpes couvrent de l’objet&#xa0;: %1</translation>
    </message>
    <message>
        <source>Each as the pad looks at the object, tangent up; dashed: the whole pad; filled: what it covers; cross: the middle of that; red: where a ray ends before the pad does</source>
        <translation>Chacune comme elle regarde l’objet, tangente vers le haut&#xa0;; pointillé&#xa0;: la pulpe entière&#xa0;; rempli&#xa0;: ce qu’elle couvre&#xa0;; croix&#xa0;: son milieu&#xa0;; rouge&#xa0;: où un rayon finit avant la pulpe</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>bord</translation>
    </message>
    <message>
        <source>friction ends</source>
        <translation>fin du frottement</translation>
    </message>
    <message>
        <source>surface ends</source>
        <translation>fin de la surface</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatientForm</name>
    <message>
        <source>Choose or add a p&amp;atient</source>
        <translation>Choisir ou a&amp;jouter un patient</translation>
    </message>
    <message>
        <source>Choose or add a patient</source>
        <translation>Choisir ou ajouter un patient</translation>
    </message>
    <message>
        <source>Opens the list of patients (Alt+A)</source>
        <translation>Ouvre la liste des patients (Alt+J)</translation>
    </message>
    <message>
        <source>the whole screen</source>
        <translation>tout l’écran</translation>
    </message>
    <message>
        <source>the left half</source>
        <translation>la moitié gauche</translation>
    </message>
    <message>
        <source>the right half</source>
        <translation>la moitié droite</translation>
    </message>
    <message>
        <source>What the patient sees</source>
        <translation>Ce que voit le patient</translation>
    </message>
    <message>
        <source>For somebody with half the field of view: all is shown on that side (Tab, then arrow keys)</source>
        <translation>Pour un demi-champ visuel&#xa0;: tout est affiché de ce côté (Tab, puis flèches)</translation>
    </message>
    <message>
        <source>Calm: nothing scrolls</source>
        <translation>Calme&#xa0;: rien ne défile</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>Sons</translation>
    </message>
    <message>
        <source>Force can be heard</source>
        <translation>La force s’entend</translation>
    </message>
    <message>
        <source>Instructions are spoken</source>
        <translation>Les consignes sont parlées</translation>
    </message>
    <message>
        <source>The target stands still while the mark crosses it, fingers do not approach</source>
        <translation>La cible reste fixe pendant que la marque la traverse, les doigts n’approchent pas</translation>
    </message>
    <message>
        <source>Soft tones for begin, success and targets</source>
        <translation>Sons doux pour le début, la réussite et les cibles</translation>
    </message>
    <message>
        <source>A tone that is higher above the target, lower below it and quiet on it</source>
        <translation>Un son plus aigu au-dessus de la cible, plus grave au-dessous, muet dessus</translation>
    </message>
    <message>
        <source>By the voice of this computer, in the language of the window</source>
        <translation>Par la voix de cet ordinateur, dans la langue de la fenêtre</translation>
    </message>
    <message>
        <source>Sees</source>
        <translation>Voit</translation>
    </message>
    <message>
        <source>%1 (Tab, then space)</source>
        <translation>%1 (Tab, puis Espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatientPage</name>
    <message>
        <source>Progress</source>
        <translation>Évolution</translation>
    </message>
    <message>
        <source>The main measures over the sessions (F4)</source>
        <translation>Les mesures principales au fil des séances (F4)</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Any two sessions side by side (F5)</source>
        <translation>Deux séances au choix côte à côte (F5)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>The opened trial: signals and replay (F6)</source>
        <translation>L’essai ouvert&#xa0;: signaux et relecture (F6)</translation>
    </message>
    <message>
        <source>Choose a trial at the left and open it with Enter.</source>
        <translation>Choisissez un essai à gauche et ouvrez-le avec Entrée.</translation>
    </message>
    <message>
        <source>trial %1, %2</source>
        <translation>essai %1, %2</translation>
    </message>
    <message>
        <source>This trial cannot be read: %1</source>
        <translation>Cet essai ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>No patient</source>
        <translation>Aucun patient</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>Loading …</source>
        <translation>Chargement …</translation>
    </message>
    <message>
        <source>Choose a patient to see what is stored.</source>
        <translation>Choisissez un patient pour voir ses données.</translation>
    </message>
    <message>
        <source>The database is not open yet.</source>
        <translation>La base de données n’est pas encore ouverte.</translation>
    </message>
    <message>
        <source>Nothing stored for this patient yet.</source>
        <translation>Rien n’est encore enregistré pour ce patient.</translation>
    </message>
    <message>
        <source>%1, %2, from %3 to %4</source>
        <translation>%1, %2, du %3 au %4</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PatientWindow</name>
    <message>
        <source>IsoGrasp: patient screen</source>
        <translation>IsoGrasp&#xa0;: écran du patient</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PersonCard</name>
    <message>
        <source>Person</source>
        <translation>Personne</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Affected side: left</source>
        <translation>Côté atteint&#xa0;: gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Affected side: right</source>
        <translation>Côté atteint&#xa0;: droite</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Affected sides: both</source>
        <translation>Côtés atteints&#xa0;: les deux</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Affected side: none, healthy</source>
        <translation>Côté atteint&#xa0;: aucun, personne saine</translation>
    </message>
    <message>
        <source>Dominant hand: left</source>
        <translation>Main dominante&#xa0;: gauche</translation>
    </message>
    <message>
        <source>Dominant hand: right</source>
        <translation>Main dominante&#xa0;: droite</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Day of the onset</source>
        <translation>Jour du début</translation>
    </message>
    <message>
        <source>Year-month-day; empty: not known; Up and Down change it (Ctrl+Shift+O)</source>
        <translation>Jour/mois/année&#xa0;; vide&#xa0;: inconnu&#xa0;; Haut et Bas le changent (Ctrl+Maj+O)</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>Objectifs</translation>
    </message>
    <message>
        <source>What the patient wants to do again; stays in the clinic, never in a research export; Ctrl+Z takes back what was typed (Ctrl+Shift+G)</source>
        <translation>Ce que le patient veut pouvoir refaire&#xa0;; reste à la clinique, jamais dans un export de recherche&#xa0;; Ctrl+Z annule la saisie (Ctrl+Maj+G)</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>What colleagues should know; stays in the clinic, never in a research export; Ctrl+Z takes back what was typed (Ctrl+Shift+N)</source>
        <translation>Ce que les collègues doivent savoir&#xa0;; reste à la clinique, jamais dans un export de recherche&#xa0;; Ctrl+Z annule la saisie (Ctrl+Maj+N)</translation>
    </message>
    <message>
        <source>Affected side</source>
        <translation>Côté atteint</translation>
    </message>
    <message>
        <source>Dominant hand</source>
        <translation>Main dominante</translation>
    </message>
    <message>
        <source>Onset</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Not stored. %1</source>
        <translation>Non enregistré. %1</translation>
    </message>
    <message>
        <source>Female</source>
        <translation>Féminin</translation>
    </message>
    <message>
        <source>Sex: female</source>
        <translation>Sexe&#xa0;: féminin</translation>
    </message>
    <message>
        <source>Male</source>
        <translation>Masculin</translation>
    </message>
    <message>
        <source>Sex: male</source>
        <translation>Sexe&#xa0;: masculin</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>Sex: other</source>
        <translation>Sexe&#xa0;: autre</translation>
    </message>
    <message>
        <source>Year of birth</source>
        <translation>Année de naissance</translation>
    </message>
    <message>
        <source>Four digits; empty: not known; the day belongs to the name (Ctrl+Shift+B)</source>
        <translation>Quatre chiffres&#xa0;; vide&#xa0;: non connue&#xa0;; le jour va avec le nom (Ctrl+Maj+B)</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>Sexe</translation>
    </message>
    <message>
        <source>Saved, but for the onset</source>
        <translation>Enregistré, sauf le début</translation>
    </message>
    <message>
        <source>Saved, but for the year of birth</source>
        <translation>Enregistré, sauf l’année de naissance</translation>
    </message>
    <message>
        <source>Not stored. Give a year from %1 to %2.</source>
        <translation>Non enregistré. Donnez une année de %1 à %2.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PictureCheckView</name>
    <message>
        <source>The hand is moved to the right, up and away, towards the screen; the picture must do the same. Before the first object (Tab, then space)</source>
        <translation>La main se déplace vers la droite, vers le haut et s’éloigne, vers l’écran&#xa0;; l’image doit faire de même. Avant le premier objet (Tab, puis espace)</translation>
    </message>
    <message>
        <source>The hand moves 10 cm to the right, and rests.</source>
        <translation>La main se déplace de 10 cm vers la droite, puis reste immobile.</translation>
    </message>
    <message>
        <source>It moves 10 cm up, and rests.</source>
        <translation>Elle se déplace de 10 cm vers le haut, puis reste immobile.</translation>
    </message>
    <message>
        <source>It moves 10 cm away, towards the screen, and rests.</source>
        <translation>Elle s’éloigne de 10 cm, vers l’écran, puis reste immobile.</translation>
    </message>
    <message>
        <source>The hand is held still where the tracker sees it.</source>
        <translation>La main reste immobile, là où le suivi de la main la voit.</translation>
    </message>
    <message>
        <source>✓ The picture moves as the hand does.</source>
        <translation>✓ L’image bouge comme la main.</translation>
    </message>
    <message>
        <source>✗ In the picture it went %1° off. Once more; if it stays so, the tracker stands another way than its program says: no object comes.</source>
        <translation>✗ Dans l’image, elle a dévié de %1°. Recommencez&#xa0;; si cela persiste, le suivi de la main est orienté autrement que ne le dit son programme&#xa0;: aucun objet ne vient.</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Arrêter le contrôle</translation>
    </message>
    <message>
        <source>Check the picture</source>
        <translation>Contrôler l’image</translation>
    </message>
    <message>
        <source>You move the object to the right, up and away, towards the screen; the picture must do the same. Before the first trial (Tab, then space)</source>
        <translation>Vous déplacez l’objet à droite, en haut et au loin vers l’écran&#xa0;; l’image doit faire de même. Avant le premier essai (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Move the object 10 cm to the right, seen by the patient, and rest.</source>
        <translation>Déplacez l’objet de 10 cm à droite, vu du patient, puis repos.</translation>
    </message>
    <message>
        <source>Move it 10 cm up, and rest.</source>
        <translation>De 10 cm vers le haut, puis repos.</translation>
    </message>
    <message>
        <source>Move it 10 cm away, towards the screen, and rest.</source>
        <translation>De 10 cm au loin, vers l’écran, puis repos.</translation>
    </message>
    <message>
        <source>Hold the object still where the cameras see it.</source>
        <translation>Gardez l’objet immobile, en vue des caméras.</translation>
    </message>
    <message>
        <source>✓ The picture moves as the object does.</source>
        <translation>✓ L’image bouge comme l’objet.</translation>
    </message>
    <message>
        <source>✗ In the picture it went %1° off. Once more; if it stays so, [view] of the rig names other axes: nothing begins that is done by this picture.</source>
        <translation>✗ Dans l’image, il a dévié de %1°. Recommencez&#xa0;; si cela persiste, [view] du jeu de marqueurs nomme d’autres axes&#xa0;: aucun essai guidé par cette image ne commence.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PlatformsForm</name>
    <message>
        <source>Platform of the left hand</source>
        <translation>Plateforme de la main gauche</translation>
    </message>
    <message>
        <source>Platform of the right hand</source>
        <translation>Plateforme de la main droite</translation>
    </message>
    <message>
        <source>What is present now, and a simulated person (Tab, then arrow keys)</source>
        <translation>Ce qui est présent, et une personne simulée (Tab, puis flèches)</translation>
    </message>
    <message>
        <source>Left platform</source>
        <translation>Plateforme gauche</translation>
    </message>
    <message>
        <source>Right platform</source>
        <translation>Plateforme droite</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureDesk</name>
    <message>
        <source>Not recorded: the arm moved by %1 mm (SD). Hold it still.</source>
        <translation>Non enregistré&#xa0;: le bras a bougé de&#xa0;%1 mm (écart-type). Gardez-le immobile.</translation>
    </message>
    <message>
        <source>Not recorded: elbow, forearm, hand and object were not seen together for a second.</source>
        <translation>Non enregistré&#xa0;: coude, avant-bras, main et objet n’ont pas été vus ensemble pendant une seconde.</translation>
    </message>
    <message>
        <source>Recorded for a second; it moved by %1 mm (SD).</source>
        <translation>Enregistré pendant une seconde&#xa0;; il a bougé de&#xa0;%1 mm (écart-type).</translation>
    </message>
    <message>
        <source>Recorded postures</source>
        <translation>Postures enregistrées</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureEditor</name>
    <message>
        <source>Changed postures are another series: what is measured with them is not compared with what was measured before.</source>
        <translation>Des postures changées sont une autre série&#xa0;: ce qui est mesuré avec elles n’est pas comparé à ce qui l’a été avant.</translation>
    </message>
    <message>
        <source>Name of the file</source>
        <translation>Nom du fichier</translation>
    </message>
    <message>
        <source>For people; Enter takes it (Tab)</source>
        <translation>Pour les personnes&#xa0;; Entrée le prend (Tab)</translation>
    </message>
    <message>
        <source>Postures of the file</source>
        <translation>Postures du fichier</translation>
    </message>
    <message>
        <source>Arrow keys choose one; X, Y and Z turn its link, with Shift the other way; Ctrl with arrow and page keys moves it</source>
        <translation>Les flèches en choisissent une&#xa0;; X, Y et Z tournent son segment, avec Maj dans l’autre sens&#xa0;; Ctrl avec les flèches et les touches de page le déplace</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the posture</source>
        <translation>Copier la posture</translation>
    </message>
    <message>
        <source>The same posture once more (Tab, then space)</source>
        <translation>La même posture encore une fois (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the posture</source>
        <translation>Supprimer la posture</translation>
    </message>
    <message>
        <source>Takes it out of the file; Undo brings it back (Delete)</source>
        <translation>La retire du fichier&#xa0;; Annuler la ramène (Suppr)</translation>
    </message>
    <message>
        <source>Name of the posture</source>
        <translation>Nom de la posture</translation>
    </message>
    <message>
        <source>Tasks call it by that; Enter takes it (Tab)</source>
        <translation>Les tâches l’appellent ainsi&#xa0;; Entrée le prend (Tab)</translation>
    </message>
    <message>
        <source>Posture</source>
        <translation>Posture</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>What turns</source>
        <translation>Ce qui tourne</translation>
    </message>
    <message>
        <source>What lies beyond it goes along (arrow keys)</source>
        <translation>Ce qui est au-delà suit (flèches)</translation>
    </message>
    <message>
        <source>About whose axes</source>
        <translation>Autour de quels axes</translation>
    </message>
    <message>
        <source>They are drawn in the picture, at the origin about which is turned (arrow keys)</source>
        <translation>Ils sont dessinés dans l’image, au point autour duquel on tourne (flèches)</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changer</translation>
    </message>
    <message>
        <source>axes of</source>
        <translation>axes de</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn by, in degrees</source>
        <translation>Tourner de, en degrés</translation>
    </message>
    <message>
        <source>One step of a turn (arrow keys)</source>
        <translation>Un pas de rotation (flèches)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Move by, in millimetres</source>
        <translation>Déplacer de, en millimètres</translation>
    </message>
    <message>
        <source>One step of a move (arrow keys)</source>
        <translation>Un pas de déplacement (flèches)</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Tourner de</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Déplacer de</translation>
    </message>
    <message>
        <source>Turn about %1, %2</source>
        <translation>Tourner autour de&#xa0;%1,&#xa0;%2</translation>
    </message>
    <message>
        <source>Move along %1, %2</source>
        <translation>Déplacer le long de&#xa0;%1,&#xa0;%2</translation>
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
        <translation>Part du chemin depuis la posture initiale, en pour cent</translation>
    </message>
    <message>
        <source>0 is the initial posture, 100 this one (arrow keys)</source>
        <translation>0 est la posture initiale, 100 celle-ci (flèches)</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouvelle</translation>
    </message>
    <message>
        <source>A new posture so far on the way</source>
        <translation>Une nouvelle posture à ce point du chemin</translation>
    </message>
    <message>
        <source>Adds a posture so far on the way to this one; this one stays (Tab, then space)</source>
        <translation>Ajoute une posture à ce point du chemin vers celle-ci, qui reste (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Shorten</source>
        <translation>Raccourcir</translation>
    </message>
    <message>
        <source>Shorten this posture to so much of its way</source>
        <translation>Raccourcir cette posture à cette part de son chemin</translation>
    </message>
    <message>
        <source>Takes this posture back to so much of its way (Tab, then space)</source>
        <translation>Ramène cette posture à cette part de son chemin (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Way from the initial one</source>
        <translation>Chemin depuis l’initiale</translation>
    </message>
    <message>
        <source>Recording the arm</source>
        <translation>Enregistrement du bras</translation>
    </message>
    <message>
        <source>The arm is held still for a second</source>
        <translation>Le bras reste immobile une seconde</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Record the arm: next posture</source>
        <translation>Enregistrer le bras&#xa0;: posture suivante</translation>
    </message>
    <message>
        <source>Record the arm: new file</source>
        <translation>Enregistrer le bras&#xa0;: nouveau fichier</translation>
    </message>
    <message>
        <source>The arm is held still for a second, as guided; the same markers as in this file (Tab, then space)</source>
        <translation>Le bras reste immobile une seconde, tel que guidé&#xa0;; les mêmes marqueurs que dans ce fichier (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>The arm is held still for a second and becomes the initial posture of a new file: postures of one arm with other markers do not fit together (Tab, then space)</source>
        <translation>Le bras reste immobile une seconde et devient la posture initiale d’un nouveau fichier&#xa0;: des postures avec des marqueurs posés autrement ne vont pas ensemble (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>%1 – all others are seen from it</source>
        <translation>%1 – toutes les autres sont vues depuis elle</translation>
    </message>
    <message>
        <source>The initial posture: the arm is held so before the work.</source>
        <translation>La posture initiale&#xa0;: le bras est tenu ainsi avant le travail.</translation>
    </message>
    <message>
        <source>%1 %2°, %3 mm</source>
        <translation>%1&#xa0;%2°,&#xa0;%3 mm</translation>
    </message>
    <message>
        <source>From the initial posture: %1</source>
        <translation>Depuis la posture initiale&#xa0;:&#xa0;%1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureFields</name>
    <message>
        <source>Left hand</source>
        <translation>Main gauche</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Main droite</translation>
    </message>
    <message>
        <source>Posture and straps of this hand (Tab, then space)</source>
        <translation>Posture et sangles de cette main (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>%1, left hand</source>
        <translation>%1, main gauche</translation>
    </message>
    <message>
        <source>%1, right hand</source>
        <translation>%1, main droite</translation>
    </message>
    <message>
        <source>%1: the marks as written on them (Tab)</source>
        <translation>%1&#xa0;: les repères tels qu’inscrits (Tab)</translation>
    </message>
    <message>
        <source>%1 (Tab, then arrow keys)</source>
        <translation>%1 (Tab, puis flèches)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureForm</name>
    <message>
        <source>Not in sight: %1</source>
        <translation>Hors de vue&#xa0;: %1</translation>
    </message>
    <message>
        <source>In sight. Hold the arm still.</source>
        <translation>En vue. Gardez le bras immobile.</translation>
    </message>
    <message>
        <source>In sight and still: measure it now.</source>
        <translation>En vue et immobile&#xa0;: mesurez maintenant.</translation>
    </message>
    <message>
        <source>Measure the start posture</source>
        <translation>Mesurer la posture de départ</translation>
    </message>
    <message>
        <source>Measuring the start posture</source>
        <translation>Mesure de la posture de départ</translation>
    </message>
    <message>
        <source>The arm is looked for once the cameras are connected.</source>
        <translation>Le bras est cherché dès que les caméras sont connectées.</translation>
    </message>
    <message>
        <source>The arm is held still for a second; targets are made for its size (Tab, then space)</source>
        <translation>Le bras reste immobile une seconde&#xa0;; les cibles sont faites pour sa taille (Tab, puis Espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PostureView</name>
    <message>
        <source>The posture</source>
        <translation>La posture</translation>
    </message>
    <message>
        <source>The arm in this posture from the front, from the side and from above</source>
        <translation>Le bras dans cette posture de face, de côté et de dessus</translation>
    </message>
    <message>
        <source>X, Y and Z turn the link, with Shift the other way; Ctrl with arrow and page keys moves it; one square is 10 cm</source>
        <translation>X, Y et Z tournent le segment, avec Maj dans l’autre sens&#xa0;; Ctrl avec les flèches et les touches de page le déplace&#xa0;; un carré fait 10 cm</translation>
    </message>
    <message>
        <source>The arm, and dashed the object in the initial posture</source>
        <translation>Le bras, et en pointillé l’objet dans la posture initiale</translation>
    </message>
    <message>
        <source>The patient sees the object at the start, and this target.</source>
        <translation>Le patient voit l’objet au départ, et cette cible.</translation>
    </message>
    <message>
        <source>Drawn flat: this display has no OpenGL for the 3D picture.</source>
        <translation>Dessin à plat&#xa0;: cet affichage n’a pas OpenGL pour l’image 3D.</translation>
    </message>
    <message>
        <source>The object in three dimensions</source>
        <translation>L’objet en trois dimensions</translation>
    </message>
    <message>
        <source>As the patient sees it; the keys are those of the three sides</source>
        <translation>Comme le patient le voit&#xa0;; les touches sont celles des trois côtés</translation>
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
        <translation>Main du jour</translation>
    </message>
    <message>
        <source>Screening</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Zero, empty</source>
        <translation>Zéro (sans la main)</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>Main en place</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>%1: asked in every session (%2)</source>
        <translation>%1&#xa0;: demandée à chaque séance (%2)</translation>
    </message>
    <message>
        <source>&amp;Left hand</source>
        <translation>Main &amp;gauche</translation>
    </message>
    <message>
        <source>Alt+L</source>
        <translation>Alt+G</translation>
    </message>
    <message>
        <source>&amp;Right hand</source>
        <translation>Main &amp;droite</translation>
    </message>
    <message>
        <source>Alt+R</source>
        <translation>Alt+D</translation>
    </message>
    <message>
        <source>Yes, the less affected hand</source>
        <translation>Oui, la main la moins atteinte</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>set</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesurée</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>one by one</source>
        <translation>une par une</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>once more</source>
        <translation>à refaire</translation>
    </message>
    <message>
        <source>Start posture</source>
        <translation>Posture de départ</translation>
    </message>
    <message>
        <source>Arm today</source>
        <translation>Bras du jour</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>Device or cameras</source>
        <translation>Appareil ou caméras</translation>
    </message>
    <message>
        <source>Zero or start posture</source>
        <translation>Zéro ou posture de départ</translation>
    </message>
    <message>
        <source>&amp;Left arm</source>
        <translation>Bras &amp;gauche</translation>
    </message>
    <message>
        <source>&amp;Right arm</source>
        <translation>Bras &amp;droit</translation>
    </message>
    <message>
        <source>Yes, the less affected arm</source>
        <translation>Oui, le bras le moins atteint</translation>
    </message>
    <message>
        <source>The affected side is the other one; this one is meant (Tab, then space)</source>
        <translation>Le côté atteint est l’autre&#xa0;; c’est bien celui-ci (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Suivi de la main</translation>
    </message>
    <message>
        <source>Entry test</source>
        <translation>Test d’entrée</translation>
    </message>
    <message>
        <source>opens %1 mm</source>
        <translation>s’ouvre de %1 mm</translation>
    </message>
    <message>
        <source>Hands today</source>
        <translation>Mains du jour</translation>
    </message>
    <message>
        <source>Platforms</source>
        <translation>Plateformes</translation>
    </message>
    <message>
        <source>Zeros, both empty</source>
        <translation>Zéros (sans les mains)</translation>
    </message>
    <message>
        <source>Hands in</source>
        <translation>Mains en place</translation>
    </message>
    <message>
        <source>Both, on two platforms</source>
        <translation>Les deux, sur deux plateformes</translation>
    </message>
    <message>
        <source>Both hands, on two platforms</source>
        <translation>Les deux mains, sur deux plateformes</translation>
    </message>
    <message>
        <source>Each hand on a platform of its own: asked in every session (Tab, then space)</source>
        <translation>Chaque main sur sa plateforme&#xa0;: demandé à chaque séance (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>Protocole&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::PrimaryCard</name>
    <message>
        <source>Primary measures</source>
        <translation>Mesures principales</translation>
    </message>
    <message>
        <source>Measure that gets a verdict of change</source>
        <translation>Mesure dont le changement est évalué</translation>
    </message>
    <message>
        <source>Measure that gets a verdict of change; Alt+Down shows all (Ctrl+Shift+M)</source>
        <translation>Mesure dont le changement est évalué&#xa0;; Alt+Bas les montre toutes (Ctrl+Maj+M)</translation>
    </message>
    <message>
        <source>Who chooses the measure</source>
        <translation>Qui choisit la mesure</translation>
    </message>
    <message>
        <source>Make this a primary measure</source>
        <translation>En faire une mesure principale</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Choisie</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Par</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>No measure is chosen: no change is judged. Choose up to four before the second assessment.</source>
        <translation>Aucune mesure n’est choisie&#xa0;: aucun changement n’est évalué. Choisissez-en jusqu’à quatre avant le deuxième bilan.</translation>
    </message>
    <message>
        <source>New primary measure</source>
        <translation>Nouvelle mesure principale</translation>
    </message>
    <message>
        <source>Four are chosen. Remove one to choose another.</source>
        <translation>Quatre sont choisies. Retirez-en une pour en choisir une autre.</translation>
    </message>
    <message>
        <source>Measures can be chosen from the first assessment on.</source>
        <translation>Les mesures peuvent être choisies dès le premier bilan.</translation>
    </message>
    <message>
        <source>Not added. This measure is chosen already.</source>
        <translation>Non ajouté. Cette mesure est déjà choisie.</translation>
    </message>
    <message>
        <source>Not added. Say who chooses it.</source>
        <translation>Non ajouté. Indiquez qui la choisit.</translation>
    </message>
    <message>
        <source>Chosen by</source>
        <translation>Choisie par</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ProfilePanel</name>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Try to store or read it again</source>
        <translation>Réessayer d’enregistrer ou de lire</translation>
    </message>
    <message>
        <source>Try to store or read it again (Ctrl+Shift+R)</source>
        <translation>Réessayer d’enregistrer ou de lire (Ctrl+Maj+R)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Choose a patient first.</source>
        <translation>Choisissez d’abord un patient.</translation>
    </message>
    <message>
        <source>⚠ Not saved: %1</source>
        <translation>⚠ Non enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>⚠ Not read: %1</source>
        <translation>⚠ Non lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Lecture …</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Enregistrement …</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Enregistré</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ProtocolForm</name>
    <message>
        <source>%1, practice (%2)</source>
        <translation>%1, entraînement (%2)</translation>
    </message>
    <message>
        <source>%1, practice</source>
        <translation>%1, entraînement</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>About %1 min, at most %2 min, rests included</source>
        <translation>Environ %1 min, au plus %2 min, repos compris</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>What this session consists of; chosen before connecting (Alt+7, then arrow keys)</source>
        <translation>Le contenu de cette séance&#xa0;; choisi avant la connexion (Alt+7, puis flèches)</translation>
    </message>
    <message>
        <source>Tasks one by one</source>
        <translation>Tâches une par une</translation>
    </message>
    <message>
        <source>&amp;Go on with it</source>
        <translation>&amp;Reprendre</translation>
    </message>
    <message>
        <source>Go on with the interrupted protocol</source>
        <translation>Reprendre le protocole interrompu</translation>
    </message>
    <message>
        <source>What was done is not asked again; zero and resting force are (Alt+G)</source>
        <translation>Ce qui est fait n’est plus demandé, sauf mise à zéro et force de repos (Alt+R)</translation>
    </message>
    <message>
        <source>&amp;Begin anew</source>
        <translation>Reco&amp;mmencer</translation>
    </message>
    <message>
        <source>Begin the protocol anew</source>
        <translation>Recommencer le protocole</translation>
    </message>
    <message>
        <source>Everything is asked again (Alt+B)</source>
        <translation>Tout est redemandé (Alt+M)</translation>
    </message>
    <message>
        <source>Steps of the protocol</source>
        <translation>Étapes du protocole</translation>
    </message>
    <message>
        <source>What is done and what comes (Tab, arrow keys)</source>
        <translation>Ce qui est fait et ce qui vient (Tab, flèches)</translation>
    </message>
    <message>
        <source>You choose every task yourself.</source>
        <translation>Vous choisissez vous-même chaque tâche.</translation>
    </message>
    <message numerus="yes">
        <source>Interrupted today after %n step(s). Go on where it stopped?</source>
        <translation>
            <numerusform>Interrompu aujourd’hui après %n étape. Reprendre là&#xa0;?</numerusform>
            <numerusform>Interrompu aujourd’hui après %n étapes. Reprendre là&#xa0;?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::QuestionsPanel</name>
    <message>
        <source>About the last trial</source>
        <translation>À propos du dernier essai</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Sans réponse</translation>
    </message>
    <message>
        <source>%1: no answer</source>
        <translation>%1&#xa0;: sans réponse</translation>
    </message>
    <message>
        <source>%1: %2, %3: %4. Each answer is kept at once; another one corrects it.</source>
        <translation>%1&#xa0;: %2, %3&#xa0;: %4. Chaque réponse est enregistrée aussitôt&#xa0;; une autre la corrige.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::RatingPanel</name>
    <message>
        <source>Kept: effort %1, pain %2. Another number corrects it.</source>
        <translation>Conservé&#xa0;: effort %1, douleur %2. Un autre nombre corrige.</translation>
    </message>
    <message>
        <source>Correct: effort %1, pain %2</source>
        <translation>Corriger&#xa0;: effort %1, douleur %2</translation>
    </message>
    <message>
        <source>Shows the last answer again; another number corrects it, and what it was is kept (Tab, then space)</source>
        <translation>Montre de nouveau la dernière réponse&#xa0;; un autre nombre la corrige, et ce qu’elle était est conservé (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>The patient says</source>
        <translation>Le patient dit</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Effort</translation>
    </message>
    <message>
        <source>Pain</source>
        <translation>Douleur</translation>
    </message>
    <message>
        <source>0: none, 10: the most. Asked after every block.</source>
        <translation>0&#xa0;: aucun, 10&#xa0;: le plus fort. Demandé après chaque bloc.</translation>
    </message>
    <message>
        <source>Effort</source>
        <comment>beside its numbers</comment>
        <translation>Effort</translation>
    </message>
    <message>
        <source>Pain</source>
        <comment>beside its numbers</comment>
        <translation>Douleur</translation>
    </message>
    <message>
        <source>Kept: effort %1, pain %2, shoulder %3. Another number corrects it.</source>
        <translation>Conservé&#xa0;: effort %1, douleur %2, épaule %3. Un autre nombre corrige.</translation>
    </message>
    <message>
        <source>Correct: effort %1, pain %2, shoulder %3</source>
        <translation>Corriger&#xa0;: effort %1, douleur %2, épaule %3</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <comment>beside its numbers</comment>
        <translation>Épaule</translation>
    </message>
    <message>
        <source>Shoulder pain</source>
        <translation>Douleur à l’épaule</translation>
    </message>
    <message>
        <source>A number is missing: nothing is kept yet.</source>
        <translation>Il manque un nombre&#xa0;: rien n’est encore conservé.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::RecordsCard</name>
    <message>
        <source>The records</source>
        <translation>La base de données</translation>
    </message>
    <message>
        <source>Names, notes and goals are sealed. What somebody without a password changes is found at the login or by isograsp db check.</source>
        <translation>Les noms, notes et objectifs sont scellés. Ce que quelqu’un modifie sans mot de passe est découvert à la connexion ou par isograsp db check.</translation>
    </message>
    <message>
        <source>Not hidden from whoever has the file: codes, dates, forces, the names of those who work here. Not noticed: an older copy of the file that is put back together with its FILE-audit.</source>
        <translation>Non caché à qui possède le fichier&#xa0;: codes, dates, forces, noms de ceux qui travaillent ici. Non remarqué&#xa0;: une copie plus ancienne du fichier, remise en place avec son FILE-audit.</translation>
    </message>
    <message>
        <source>This database has no passphrase: whoever has the file can read all of it. What is changed, removed or added by another program is found by isograsp db check.</source>
        <translation>Cette base de données n’a pas de phrase de passe&#xa0;: qui possède le fichier peut tout lire. Ce qu’un autre programme modifie, supprime ou ajoute est découvert par isograsp db check.</translation>
    </message>
    <message>
        <source>Not noticed: changes by somebody who computes seals and log anew, and an older copy of the file that is put back. isograsp db protect gives the database a passphrase.</source>
        <translation>Non remarqué&#xa0;: des modifications de quelqu’un qui recalcule sceaux et journal, et une copie plus ancienne du fichier remise en place. isograsp db protect donne une phrase de passe à la base de données.</translation>
    </message>
    <message>
        <source>What helps: an encrypted disk, copies elsewhere, and on paper the head of the audit log and the key of signed backups (isograsp db audit).</source>
        <translation>Ce qui aide&#xa0;: un disque chiffré, des copies ailleurs et, sur papier, la tête du journal et la clé des sauvegardes signées (isograsp db audit).</translation>
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
        <translation>Rapport d’évolution</translation>
    </message>
    <message>
        <source>&amp;From session</source>
        <translation>&amp;De la séance</translation>
    </message>
    <message>
        <source>&amp;To session</source>
        <translation>À la &amp;séance</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What is written (Alt+O, then arrow keys)</source>
        <translation>Ce qui est écrit (Alt+F, puis flèches)</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Web page (HTML)</source>
        <translation>Page web (HTML)</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>The web page has the same plots and numbers, with a table beside every plot.</source>
        <translation>La page web a les mêmes courbes et nombres, avec un tableau à côté de chaque courbe.</translation>
    </message>
    <message>
        <source>&amp;Save as …</source>
        <translation>&amp;Enregistrer …</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Write the patient&apos;s progress report (Ctrl+R, Alt+S)</source>
        <translation>Rédiger le rapport d’évolution du patient (Ctrl+R, Alt+E)</translation>
    </message>
    <message>
        <source>&amp;Print …</source>
        <translation>&amp;Imprimer …</translation>
    </message>
    <message>
        <source>Print the report</source>
        <translation>Imprimer le rapport</translation>
    </message>
    <message>
        <source>The pages that are shown, on paper; not during a trial (Alt+P)</source>
        <translation>Les pages affichées, sur papier&#xa0;; pas pendant un essai (Alt+I)</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>Avancement du rapport</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel the report</source>
        <translation>Annuler le rapport</translation>
    </message>
    <message>
        <source>Write no report; a file that was there stays as it is (Escape)</source>
        <translation>Ne pas rédiger de rapport&#xa0;; un fichier existant reste intact (Échap)</translation>
    </message>
    <message>
        <source>S&amp;maller</source>
        <translation>&amp;Réduire</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Réduire</translation>
    </message>
    <message>
        <source>Smaller pages (Alt+M, Ctrl and the wheel)</source>
        <translation>Pages plus petites (Alt+R, Ctrl et la molette)</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>A&amp;grandir</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Larger pages (Alt+L, Ctrl and the wheel)</source>
        <translation>Pages plus grandes (Alt+G, Ctrl et la molette)</translation>
    </message>
    <message>
        <source>Fit wi&amp;dth</source>
        <translation>Pleine &amp;largeur</translation>
    </message>
    <message>
        <source>Fit width</source>
        <translation>Pleine largeur</translation>
    </message>
    <message>
        <source>A page as wide as the view (Alt+D)</source>
        <translation>Une page aussi large que la vue (Alt+L)</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Aperçu du rapport</translation>
    </message>
    <message>
        <source>The pages that will be written (arrow keys, Page Up, Page Down, Home, End)</source>
        <translation>Les pages qui seront écrites (flèches, Page préc., Page suiv., Début, Fin)</translation>
    </message>
    <message>
        <source>Report written: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</source>
        <translation>Rapport rédigé&#xa0;: &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</translation>
    </message>
    <message>
        <source>No report was written: %1</source>
        <translation>Aucun rapport n’a été rédigé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cancelled: no report was written.</source>
        <translation>Annulé&#xa0;: aucun rapport n’a été rédigé.</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Rédiger le rapport</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Page web (*.html)</translation>
    </message>
    <message>
        <source>Portable document (*.pdf)</source>
        <translation>Document PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Printing page %1 of %2 …</source>
        <translation>Impression de la page %1 sur %2 …</translation>
    </message>
    <message>
        <source>The report was sent to the printer.</source>
        <translation>Le rapport a été envoyé à l’imprimante.</translation>
    </message>
    <message>
        <source>No patient is chosen.</source>
        <translation>Aucun patient choisi.</translation>
    </message>
    <message>
        <source>Report of %1: waits for the end of the trial</source>
        <translation>Rapport de %1&#xa0;: attend la fin de l’essai</translation>
    </message>
    <message>
        <source>Report of %1: %2</source>
        <translation>Rapport de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Page %1 of %2, %3 %</source>
        <translation>Page %1 sur %2, %3 %</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Choose a patient on the start page to see the report.</source>
        <translation>Choisissez un patient sur la page d’accueil pour voir le rapport.</translation>
    </message>
    <message>
        <source>Reading what is stored …</source>
        <translation>Lecture des données …</translation>
    </message>
    <message>
        <source>Nothing can be shown.</source>
        <translation>Rien ne peut être affiché.</translation>
    </message>
    <message>
        <source>The printer takes nothing: is it connected, has it paper?</source>
        <translation>L’imprimante n’accepte rien&#xa0;: est-elle branchée, a-t-elle du papier&#xa0;?</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ReportWork</name>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>saving</source>
        <translation>enregistrement</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ReportsPage</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Report, export or values</source>
        <translation>Rapport, export ou valeurs</translation>
    </message>
    <message>
        <source>What is written for people, for research, or looked at (Tab, arrow keys)</source>
        <translation>Ce qui est écrit pour des personnes, pour la recherche, ou consulté (Tab, flèches)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::RunPanel</name>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>Prot&amp;ocol</source>
        <translation>Prot&amp;ocole</translation>
    </message>
    <message>
        <source>Follow the protocol</source>
        <translation>Suivre le protocole</translation>
    </message>
    <message>
        <source>The protocol says what comes (Alt+O)</source>
        <translation>Le protocole dit ce qui vient (Alt+O)</translation>
    </message>
    <message>
        <source>One &amp;task</source>
        <translation>Une &amp;tâche</translation>
    </message>
    <message>
        <source>Choose one task</source>
        <translation>Choisir une tâche</translation>
    </message>
    <message>
        <source>Choose a task yourself; the protocol waits meanwhile (Alt+T)</source>
        <translation>Choisir vous-même une tâche&#xa0;; le protocole attend (Alt+T)</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Choose what the patient will do (Alt+T, then arrow keys)</source>
        <translation>Choisir ce que fera le patient (Alt+T, puis flèches)</translation>
    </message>
    <message>
        <source>Practice, not an assess&amp;ment</source>
        <translation>Entraînement, hors &amp;bilan</translation>
    </message>
    <message>
        <source>Practice trial</source>
        <translation>Essai d’entraînement</translation>
    </message>
    <message>
        <source>A practice trial is recorded but counts for no assessment (Alt+M)</source>
        <translation>Un essai d’entraînement est enregistré mais ne compte dans aucun bilan (Alt+B)</translation>
    </message>
    <message>
        <source>Goes on by itsel&amp;f</source>
        <translation>Continue automati&amp;quement</translation>
    </message>
    <message>
        <source>The protocol goes on by itself</source>
        <translation>Le protocole continue automatiquement</translation>
    </message>
    <message>
        <source>After a rest the next trial begins without a press; F9 holds it (Alt+F)</source>
        <translation>Après un repos, l’essai suivant commence sans appui&#xa0;; F9 le retient (Alt+Q)</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>Lancer l’e&amp;ssai</translation>
    </message>
    <message>
        <source>Progress of the trial</source>
        <translation>Avancement de l’essai</translation>
    </message>
    <message>
        <source>How much of the trial is over</source>
        <translation>Part de l’essai écoulée</translation>
    </message>
    <message>
        <source>Easier</source>
        <translation>+ facile</translation>
    </message>
    <message>
        <source>Make the task easier</source>
        <translation>Rendre la tâche plus facile</translation>
    </message>
    <message>
        <source>The next trial is one step easier (Ctrl+Minus)</source>
        <translation>L’essai suivant est d’un cran plus facile (Ctrl+Moins)</translation>
    </message>
    <message>
        <source>Harder</source>
        <translation>+ difficile</translation>
    </message>
    <message>
        <source>Make the task harder</source>
        <translation>Rendre la tâche plus difficile</translation>
    </message>
    <message>
        <source>The next trial is one step harder (Ctrl+Plus)</source>
        <translation>L’essai suivant est d’un cran plus difficile (Ctrl+Plus)</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Repeat the last trial</source>
        <translation>Répéter le dernier essai</translation>
    </message>
    <message>
        <source>The last trial once more, beside the protocol (Ctrl+Shift+R)</source>
        <translation>Le dernier essai encore une fois, hors protocole (Ctrl+Maj+R)</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Skip the next step of the protocol</source>
        <translation>Passer l’étape suivante du protocole</translation>
    </message>
    <message>
        <source>The next task is not asked for; this is noted (Ctrl+K)</source>
        <translation>La tâche suivante n’est pas demandée&#xa0;; c’est noté (Ctrl+K)</translation>
    </message>
    <message>
        <source>&amp;Helped</source>
        <translation>Avec &amp;aide</translation>
    </message>
    <message>
        <source>The therapist helps or helped in this trial</source>
        <translation>Le thérapeute aide ou a aidé pendant cet essai</translation>
    </message>
    <message>
        <source>Such a trial is kept but counts for no assessment (Alt+H)</source>
        <translation>Un tel essai est conservé mais ne compte dans aucun bilan (Alt+A)</translation>
    </message>
    <message>
        <source>Note, then Enter</source>
        <translation>Note, puis Entrée</translation>
    </message>
    <message>
        <source>Note at this moment</source>
        <translation>Note à cet instant</translation>
    </message>
    <message>
        <source>A remark at this moment, kept with the session (Ctrl+N); Ctrl+M: a mark only</source>
        <translation>Une remarque à cet instant, gardée avec la séance (Ctrl+N)&#xa0;; Ctrl+M&#xa0;: une marque seulement</translation>
    </message>
    <message>
        <source>Stop sho&amp;wing</source>
        <translation>Arrêter la &amp;présentation</translation>
    </message>
    <message>
        <source>Show the patient ho&amp;w</source>
        <translation>Montrer au &amp;patient</translation>
    </message>
    <message>
        <source>The patient&apos;s screen shows how a healthy hand does this task (F7, Alt+W)</source>
        <translation>L’écran du patient montre comment une main saine fait cette tâche (F7, Alt+P)</translation>
    </message>
    <message>
        <source>Start: %1</source>
        <translation>Lancer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Begin (F8, Alt+S)</source>
        <translation>Commencer (F8, Alt+S)</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>Reprend&amp;re</translation>
    </message>
    <message>
        <source>Hold: do not start</source>
        <translation>Retenir&#xa0;: ne pas lancer</translation>
    </message>
    <message>
        <source>Paus&amp;e</source>
        <translation>&amp;Mettre en pause</translation>
    </message>
    <message>
        <source>Resume the trial</source>
        <translation>Reprendre l’essai</translation>
    </message>
    <message>
        <source>Hold: nothing begins by itself</source>
        <translation>Retenir&#xa0;: rien ne commence tout seul</translation>
    </message>
    <message>
        <source>Pause the trial</source>
        <translation>Mettre l’essai en pause</translation>
    </message>
    <message>
        <source>The trial stands still until it is resumed; between trials nothing begins (F9)</source>
        <translation>L’essai reste figé jusqu’à la reprise&#xa0;; entre les essais rien ne commence (F9)</translation>
    </message>
    <message>
        <source>Difficulty %1 %</source>
        <translation>Difficulté %1 %</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>Rédiger le rapport…</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Rédiger le rapport</translation>
    </message>
    <message>
        <source>The report of this patient, on its page (Ctrl+R)</source>
        <translation>Le rapport de ce patient, sur sa page (Ctrl+R)</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>Disconnect: end the session</source>
        <translation>Déconnecter&#xa0;: finir la séance</translation>
    </message>
    <message>
        <source>End the session and disconnect (Tab, then Enter)</source>
        <translation>Finir la séance et déconnecter (Tab, puis Entrée)</translation>
    </message>
    <message>
        <source>The patient&apos;s screen shows how a healthy arm does this task (F7, Alt+W)</source>
        <translation>L’écran du patient montre comment un bras sain fait cette tâche (F7, Alt+W)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SafetyForm</name>
    <message>
        <source>✓ The stop was pressed, and works.</source>
        <translation>✓ L’arrêt a été pressé et fonctionne.</translation>
    </message>
    <message>
        <source>Press the pedal (F9) or the stop key (F10) once, as a test.</source>
        <translation>Appuyez une fois sur la pédale (F9) ou la touche d’arrêt (F10), comme essai.</translation>
    </message>
    <message>
        <source>✓ I stay within reach</source>
        <translation>✓ Je reste à portée de main</translation>
    </message>
    <message>
        <source>I stay within reach</source>
        <translation>Je reste à portée de main</translation>
    </message>
    <message>
        <source>As long as hands are strapped you can free them at any time; stored with the session (Tab, then space)</source>
        <translation>Tant que des mains sont sanglées, vous pouvez les libérer à tout moment&#xa0;; enregistré avec la séance (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>The less affected hand lies unstrapped in its supports, so that it can help.</source>
        <translation>La main moins atteinte repose sans sangles sur ses appuis, pour pouvoir aider.</translation>
    </message>
    <message>
        <source>It is strapped, too</source>
        <translation>Elle est sanglée aussi</translation>
    </message>
    <message>
        <source>The less affected hand is strapped, too</source>
        <translation>La main moins atteinte est sanglée aussi</translation>
    </message>
    <message>
        <source>Against the rule; stored with the session (Tab, then space)</source>
        <translation>Contre la règle&#xa0;; enregistré avec la séance (Tab, puis Espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScoreCard</name>
    <message>
        <source>Clinical scores</source>
        <translation>Scores cliniques</translation>
    </message>
    <message>
        <source>Day of the score</source>
        <translation>Jour du score</translation>
    </message>
    <message>
        <source>Sensation</source>
        <translation>Sensibilité</translation>
    </message>
    <message>
        <source>Clinical scale</source>
        <translation>Échelle clinique</translation>
    </message>
    <message>
        <source>Clinical scale (Alt+Down shows all)</source>
        <translation>Échelle clinique (Alt+Bas les montre toutes)</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Score</translation>
    </message>
    <message>
        <source>Remark on the score</source>
        <translation>Remarque sur le score</translation>
    </message>
    <message>
        <source>Muscle, side, remark</source>
        <translation>Muscle, côté, remarque</translation>
    </message>
    <message>
        <source>Add this score</source>
        <translation>Ajouter ce score</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>No score is entered. Any scale that the clinic uses anyway helps to read the trends.</source>
        <translation>Aucun score n’est saisi. Toute échelle déjà utilisée à la clinique aide à lire les évolutions.</translation>
    </message>
    <message>
        <source>New score</source>
        <translation>Nouveau score</translation>
    </message>
    <message>
        <source>Not added. %1</source>
        <translation>Non ajouté. %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScorePanel</name>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Result of the trial</source>
        <translation>Résultat de l’essai</translation>
    </message>
    <message>
        <source>So far, renewed every second</source>
        <translation>Jusqu’ici, actualisé chaque seconde</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>, practice</source>
        <translation>, entraînement</translation>
    </message>
    <message>
        <source>No trial in this session yet.</source>
        <translation>Pas encore d’essai dans cette séance.</translation>
    </message>
    <message>
        <source>All measures</source>
        <translation>Toutes les mesures</translation>
    </message>
    <message>
        <source>All measures of the trial in numbers (Ctrl+U)</source>
        <translation>Toutes les mesures de l’essai en chiffres (Ctrl+U)</translation>
    </message>
    <message>
        <source>Measures of the running or the last trial (Tab, arrow keys)</source>
        <translation>Mesures de l’essai en cours ou du dernier (Tab, flèches)</translation>
    </message>
    <message>
        <source>No earlier session to compare with</source>
        <translation>Pas de séance antérieure pour comparer</translation>
    </message>
    <message>
        <source>Last time %1, on %2</source>
        <translation>La dernière fois %1, le %2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScoreRow</name>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1&#xa0;: %2 sur %3</translation>
    </message>
    <message>
        <source>%1: %2 of %3 (Tab, then arrow keys)</source>
        <translation>%1&#xa0;: %2 sur %3 (Tab, puis flèches)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ScreeningForm</name>
    <message>
        <source>Nothing applies, no &amp;pain</source>
        <translation>Rien à signaler, pas de dou&amp;leur</translation>
    </message>
    <message>
        <source>Nothing applies, no pain: maximum allowed</source>
        <translation>Rien à signaler, pas de douleur&#xa0;: maximum autorisé</translation>
    </message>
    <message>
        <source>None of the reasons below, no pain: maximal effort is allowed (Alt+P)</source>
        <translation>Aucune des raisons ci-dessous, pas de douleur&#xa0;: l’effort maximal est autorisé (Alt+L)</translation>
    </message>
    <message>
        <source>%1 (Tab, then space)</source>
        <translation>%1 (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>Pain now, at rest</source>
        <translation>Douleur actuelle, au repos</translation>
    </message>
    <message>
        <source>Pain now</source>
        <translation>Douleur actuelle</translation>
    </message>
    <message>
        <source>You decide for this hand</source>
        <translation>Votre décision pour cette main</translation>
    </message>
    <message>
        <source>%1 of this hand today (Tab, then space)</source>
        <translation>%1 pour cette main aujourd’hui (Tab, puis Espace)</translation>
    </message>
    <message>
        <source>No target above</source>
        <translation>Cibles limitées à</translation>
    </message>
    <message>
        <source>Limit all targets</source>
        <translation>Limiter toutes les cibles</translation>
    </message>
    <message>
        <source>No target may exceed this force (Tab, then space)</source>
        <translation>Aucune cible ne dépasse cette force (Tab, puis Espace)</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Largest target in newtons</source>
        <translation>Plus grande cible en newtons</translation>
    </message>
    <message>
        <source>No target may exceed this force (Tab, arrow keys)</source>
        <translation>Aucune cible ne dépasse cette force (Tab, flèches)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SegmentedChoice</name>
    <message>
        <source>%1; pressed again: not told (%2)</source>
        <translation>%1&#xa0;; nouvel appui&#xa0;: non indiqué (%2)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SessionFlow</name>
    <message>
        <source>Left out: %1: %2; %3</source>
        <translation>Omis&#xa0;: %1&#xa0;: %2&#xa0;; %3</translation>
    </message>
    <message>
        <source>The task asks for %1° per newton; the patient&apos;s screen can show %2°, which is stored. Nearer eyes or a larger picture show more.</source>
        <translation>La tâche demande %1° par newton&#xa0;; l’écran du patient peut montrer %2°, ce qui est enregistré. Des yeux plus proches ou une image plus grande montrent davantage.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SessionSpan</name>
    <message>
        <source>%1 (Alt+%2, then arrow keys)</source>
        <translation>%1 (Alt+%2, puis flèches)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SessionTrendPlot</name>
    <message>
        <source>assessment</source>
        <translation>bilan</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>entraînement</translation>
    </message>
    <message>
        <source>helped</source>
        <translation>aidé</translation>
    </message>
    <message>
        <source>mean of a session&apos;s assessments</source>
        <translation>moyenne des bilans d’une séance</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Séance</translation>
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
        <translation>%1&#xa0;: %2 = &quot;%3&quot; n’est pas un nombre de %4 à %5&#xa0;; considéré comme non défini. Corrigez-le dans les réglages.</translation>
    </message>
    <message>
        <source>%1 is not a settings file; everything is as at first. Set it anew, or remove the file.</source>
        <translation>%1 n’est pas un fichier de réglages&#xa0;; tout est comme au départ. Réglez à nouveau, ou supprimez le fichier.</translation>
    </message>
    <message>
        <source>The settings could not be written to %1: they hold until the program ends.</source>
        <translation>Les réglages n’ont pas pu être écrits dans %1&#xa0;: ils valent jusqu’à la fin du programme.</translation>
    </message>
    <message>
        <source>%1: %2 devices are left out: without a name or an address, or behind the first %3. Add them again in a session.</source>
        <translation>%1&#xa0;: %2 appareils sont omis&#xa0;: sans nom ou sans adresse, ou après les %3 premiers. Ajoutez-les de nouveau dans une séance.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SettingsPage</name>
    <message>
        <source>This window</source>
        <translation>Cette fenêtre</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Of both windows; takes effect at once (Alt+L)</source>
        <translation>Des deux fenêtres&#xa0;; effet immédiat (Alt+L)</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>Size of letters</source>
        <translation>Taille des lettres</translation>
    </message>
    <message>
        <source>Of this window; the patient&apos;s are always large (Alt+S)</source>
        <translation>De cette fenêtre&#xa0;; celles du patient sont toujours grandes (Alt+T)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Size of letters</source>
        <translation>&amp;Taille des lettres</translation>
    </message>
    <message>
        <source>The hand is no setting: it is asked for in every session.</source>
        <translation>La main n’est pas un réglage&#xa0;: elle est demandée à chaque séance.</translation>
    </message>
    <message>
        <source>The patient&apos;s screen</source>
        <translation>L’écran du patient</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Where the patient&apos;s screen is shown (Alt+D)</source>
        <translation>Où l’écran du patient est affiché (Alt+A)</translation>
    </message>
    <message>
        <source>&amp;Display</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Distance of the eyes</source>
        <translation>Distance des yeux</translation>
    </message>
    <message>
        <source>From the patient&apos;s eyes to the screen; with the height of the picture it makes visual angles true (Alt+E)</source>
        <translation>Des yeux du patient à l’écran&#xa0;; avec la hauteur de l’image, elle donne les angles visuels exacts (Alt+D)</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Distance of the &amp;eyes</source>
        <translation>&amp;Distance des yeux</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Hauteur de l’image</translation>
    </message>
    <message>
        <source>Measured with a ruler on the patient&apos;s display, edge to edge (Alt+H)</source>
        <translation>Mesurée à la règle sur l’affichage du patient, de bord à bord (Alt+H)</translation>
    </message>
    <message>
        <source>&amp;Height of the picture</source>
        <translation>&amp;Hauteur de l’image</translation>
    </message>
    <message>
        <source>Delay of the display</source>
        <translation>Retard de l’affichage</translation>
    </message>
    <message>
        <source>From the program to the light, measured with a photodiode or a camera; stored with every session (Alt+Y)</source>
        <translation>Du programme à la lumière, mesuré avec une photodiode ou une caméra&#xa0;; enregistré avec chaque séance (Alt+R)</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>non mesuré</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Dela&amp;y of the display</source>
        <translation>&amp;Retard de l’affichage</translation>
    </message>
    <message>
        <source>Which half of the screen a patient sees, less motion, sounds and voice are chosen for each patient, in the first step of a session.</source>
        <translation>La moitié d’écran vue, moins de mouvement, les sons et la voix se choisissent pour chaque patient, à la première étape d’une séance.</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Son</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Of tones and voice (Alt+U, then arrow keys)</source>
        <translation>Des sons et de la voix (Alt+V, puis flèches)</translation>
    </message>
    <message>
        <source>Lo&amp;udness</source>
        <translation>&amp;Volume</translation>
    </message>
    <message>
        <source>Try the sound</source>
        <translation>Essayer le son</translation>
    </message>
    <message>
        <source>Plays the tone of success (Alt+T)</source>
        <translation>Joue le son de réussite (Alt+E)</translation>
    </message>
    <message>
        <source>&amp;Try the sound</source>
        <translation>&amp;Essayer le son</translation>
    </message>
    <message>
        <source>Try the voice</source>
        <translation>Essayer la voix</translation>
    </message>
    <message>
        <source>Speaks an instruction (Alt+V)</source>
        <translation>Prononce une consigne (Alt+O)</translation>
    </message>
    <message>
        <source>Try the &amp;voice</source>
        <translation>Essayer la v&amp;oix</translation>
    </message>
    <message>
        <source>Squeeze with thumb and fingers</source>
        <translation>Serrez avec le pouce et les doigts</translation>
    </message>
    <message>
        <source>The second one, if there is one</source>
        <translation>Le second, s’il y en a un</translation>
    </message>
    <message>
        <source>%1 (%2 × %3)</source>
        <translation>%1 (%2 × %3)</translation>
    </message>
    <message>
        <source>%1 (not connected now)</source>
        <translation>%1 (non connecté actuellement)</translation>
    </message>
    <message>
        <source>as the display tells: %1 cm</source>
        <translation>selon l’affichage&#xa0;: %1 cm</translation>
    </message>
    <message>
        <source>Live forces</source>
        <translation>Forces en direct</translation>
    </message>
    <message>
        <source>How the live grip is shown; newtons are what is stored and reported (Alt+R)</source>
        <translation>Affichage de la prise en direct&#xa0;; l’enregistrement et le rapport sont en newtons (Alt+F)</translation>
    </message>
    <message>
        <source>in newtons</source>
        <translation>en newtons</translation>
    </message>
    <message>
        <source>in newtons and in % of today&apos;s maximum</source>
        <translation>en newtons et en % du maximum du jour</translation>
    </message>
    <message>
        <source>Live fo&amp;rces</source>
        <translation>&amp;Forces en direct</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Who works here; stored with sessions, zeros and resting forces. In a protected database it is whoever logs in (Alt+O)</source>
        <translation>Qui travaille ici&#xa0;; enregistré avec les séances, zéros et forces de repos. Dans une base protégée, c’est la personne connectée (Alt+U)</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>Opérate&amp;ur</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SizeOffer</name>
    <message>
        <source>It has the size of the left hand</source>
        <translation>Prendre la taille de la main gauche</translation>
    </message>
    <message>
        <source>It has the size of the right hand</source>
        <translation>Prendre la taille de la main droite</translation>
    </message>
    <message>
        <source>For a hand that cannot open: the other one, mirrored; stored with the session (Tab, then space)</source>
        <translation>Pour une main qui ne peut pas s’ouvrir&#xa0;: l’autre, en miroir&#xa0;; conservé avec la séance (Tab, puis espace)</translation>
    </message>
    <message>
        <source>For a hand that cannot open. Measured in the entry test of %1.</source>
        <translation>Pour une main qui ne peut pas s’ouvrir. Mesurée au test d’entrée du %1.</translation>
    </message>
    <message>
        <source>Size: that of the left hand, entry test of %1.</source>
        <translation>Taille&#xa0;: celle de la main gauche, test d’entrée du %1.</translation>
    </message>
    <message>
        <source>Size: that of the right hand, entry test of %1.</source>
        <translation>Taille&#xa0;: celle de la main droite, test d’entrée du %1.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StableCard</name>
    <message>
        <source>Judged stable</source>
        <translation>Jugé stable</translation>
    </message>
    <message>
        <source>First day of the stable time</source>
        <translation>Premier jour de la période stable</translation>
    </message>
    <message>
        <source>Last day of the stable time</source>
        <translation>Dernier jour de la période stable</translation>
    </message>
    <message>
        <source>Clinician who judges the person stable</source>
        <translation>Clinicien qui juge la personne stable</translation>
    </message>
    <message>
        <source>Remark on the stable time</source>
        <translation>Remarque sur la période stable</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Add this stable time</source>
        <translation>Ajouter cette période stable</translation>
    </message>
    <message>
        <source>Times judged stable</source>
        <translation>Périodes jugées stables</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Du</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Au</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Par</translation>
    </message>
    <message>
        <source>No stable time is entered. Assessments of people in whom a clinician expects no change tell how large the measurement error of this clinic is.</source>
        <translation>Aucune période stable n’est saisie. Les bilans de personnes chez qui aucun changement n’est attendu révèlent l’erreur de mesure de cette clinique.</translation>
    </message>
    <message>
        <source>Stable from, until; judged by whom</source>
        <translation>Stable du, au&#xa0;; jugé par</translation>
    </message>
    <message>
        <source>Not added. %1</source>
        <translation>Non ajouté. %1</translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation>Le dernier jour précède le premier.</translation>
    </message>
    <message>
        <source>Say which clinician judges so.</source>
        <translation>Indiquez quel clinicien en juge ainsi.</translation>
    </message>
    <message>
        <source>It overlaps the time from %1 until %2.</source>
        <translation>Elle chevauche la période du %1 au %2.</translation>
    </message>
    <message>
        <source>Judged by</source>
        <translation>Jugé par</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StartPage</name>
    <message>
        <source>Patients</source>
        <translation>Patients</translation>
    </message>
    <message>
        <source>Search patients</source>
        <translation>Chercher des patients</translation>
    </message>
    <message>
        <source>Choose a patient; Enter begins a session (Tab, arrow keys)</source>
        <translation>Choisir un patient&#xa0;; Entrée commence une séance (Tab, flèches)</translation>
    </message>
    <message>
        <source>&amp;Add patient</source>
        <translation>&amp;Ajouter un patient</translation>
    </message>
    <message>
        <source>Add patient</source>
        <translation>Ajouter un patient</translation>
    </message>
    <message>
        <source>Add a patient with a generated code and begin a session (Alt+A)</source>
        <translation>Ajouter un patient avec un code généré et commencer une séance (Alt+A)</translation>
    </message>
    <message>
        <source>This clinic is empty</source>
        <translation>Cette clinique est vide</translation>
    </message>
    <message>
        <source>Add the first patient, or look around in a demonstration clinic of simulated patients. It is kept in a file of its own; nothing of it comes into this one.</source>
        <translation>Ajoutez le premier patient, ou découvrez une clinique de démonstration avec des patients simulés. Elle a son propre fichier&#xa0;; rien n’en passe dans celui-ci.</translation>
    </message>
    <message>
        <source>Open a demonstration clinic</source>
        <translation>Ouvrir une clinique de démonstration</translation>
    </message>
    <message>
        <source>Simulated patients with sessions so far, in a file of their own (Alt+D)</source>
        <translation>Patients simulés avec leurs séances, dans un fichier à part (Alt+D)</translation>
    </message>
    <message>
        <source>Making it …</source>
        <translation>Création …</translation>
    </message>
    <message>
        <source>Open a &amp;demonstration clinic</source>
        <translation>Ouvrir une clinique de &amp;démonstration</translation>
    </message>
    <message>
        <source>No patients yet. Add the first one.</source>
        <translation>Pas encore de patients. Ajoutez le premier.</translation>
    </message>
    <message>
        <source>Show &amp;names</source>
        <translation>Montrer les &amp;noms</translation>
    </message>
    <message>
        <source>Show names</source>
        <translation>Montrer les noms</translation>
    </message>
    <message>
        <source>Names beside codes, until the window is locked; the audit log says who read them (Alt+N)</source>
        <translation>Noms à côté des codes, jusqu’au verrouillage de la fenêtre&#xa0;; le journal dit qui les a lus (Alt+N)</translation>
    </message>
    <message>
        <source>Search: code, treatment, protocol</source>
        <translation>Recherche&#xa0;: code, traitement, protocole</translation>
    </message>
    <message>
        <source>A part of the code, of a treatment, of a protocol, or of a name that is shown (Ctrl+F)</source>
        <translation>Une partie du code, d’un traitement, d’un protocole ou d’un nom affiché (Ctrl+F)</translation>
    </message>
    <message>
        <source>%1 more are found by the search.</source>
        <translation>La recherche en trouve %1 de plus.</translation>
    </message>
    <message>
        <source>Nobody is found by this text.</source>
        <translation>Ce texte ne permet de trouver personne.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StateLight</name>
    <message>
        <source>State: %1</source>
        <translation>État&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StepSection</name>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>next</source>
        <translation>ensuite</translation>
    </message>
    <message>
        <source>to come</source>
        <translation>à venir</translation>
    </message>
    <message>
        <source>Step %1 of %2, %3: %4</source>
        <translation>Étape %1 sur %2, %3&#xa0;: %4</translation>
    </message>
    <message>
        <source>%1: %2. Opens and closes this step (Alt+%3)</source>
        <translation>%1&#xa0;: %2. Ouvre et ferme cette étape (Alt+%3)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::StrapForm</name>
    <message>
        <source>Hand is &amp;in and strapped</source>
        <translation>Main &amp;en place et sanglée</translation>
    </message>
    <message>
        <source>After a minute of settling the resting force is measured.</source>
        <translation>Après une minute de stabilisation, la force de repos est mesurée.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Posture an&amp;d straps …</source>
        <translation>&amp;Fixation et posture …</translation>
    </message>
    <message>
        <source>Posture and straps</source>
        <translation>Posture et sangles</translation>
    </message>
    <message>
        <source>Say how the patient sits and where the straps are (Alt+D)</source>
        <translation>Indiquer comment le patient est assis et où sont les sangles (Alt+F)</translation>
    </message>
    <message>
        <source>As last time: %1.</source>
        <translation>Comme la dernière fois&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Now: %1.</source>
        <translation>Maintenant&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not as last time: %1.</source>
        <translation>Pas comme la dernière fois&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Hand &amp;in, strapped, as last time</source>
        <translation>Main &amp;en place, comme avant</translation>
    </message>
    <message>
        <source>It is as said above. From now a minute to settle, then the resting force can be measured (Alt+I)</source>
        <translation>C’est comme indiqué ci-dessus. Dès maintenant une minute de stabilisation, puis la force de repos peut être mesurée (Alt+E)</translation>
    </message>
    <message>
        <source>Both hands &amp;in, as last time</source>
        <translation>Les deux mains &amp;en place, comme la dernière fois</translation>
    </message>
    <message>
        <source>Both hands are &amp;in</source>
        <translation>Les deux mains &amp;en place</translation>
    </message>
    <message>
        <source>Left hand, as last time: %1.</source>
        <translation>Main gauche, comme la dernière fois&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Left hand, now: %1.</source>
        <translation>Main gauche, maintenant&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Right hand, as last time: %1.</source>
        <translation>Main droite, comme la dernière fois&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Right hand, now: %1.</source>
        <translation>Main droite, maintenant&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Left hand, not as last time: %1.</source>
        <translation>Main gauche, pas comme la dernière fois&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Right hand, not as last time: %1.</source>
        <translation>Main droite, pas comme la dernière fois&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::SupportPicture</name>
    <message>
        <source>The three supports, none to be pressed</source>
        <translation>Les trois appuis, aucun à presser</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TargetCurve</name>
    <message>
        <source>%1 over time</source>
        <translation>%1 au cours du temps</translation>
    </message>
    <message>
        <source>What is asked of the patient, from begin to end; dashed: not on the screen</source>
        <translation>Ce qui est demandé au patient, du début à la fin&#xa0;; en pointillé&#xa0;: pas à l’écran</translation>
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
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>Patient screen</source>
        <translation>Écran du patient</translation>
    </message>
    <message>
        <source>Show the patient&apos;s screen: full screen on a second display (F11)</source>
        <translation>Afficher l’écran du patient&#xa0;: plein écran sur un second affichage (F11)</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Ctrl+%2)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Séance</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Rapports</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Évolution</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Personne</translation>
    </message>
    <message>
        <source>Course or person</source>
        <translation>Évolution ou personne</translation>
    </message>
    <message>
        <source>What was measured, or what is known of the person (Tab, arrow keys)</source>
        <translation>Ce qui a été mesuré, ou ce que l’on sait de la personne (Tab, flèches)</translation>
    </message>
    <message>
        <source>Marked.</source>
        <translation>Marqué.</translation>
    </message>
    <message>
        <source>RECORDED</source>
        <translation>ENREGISTRÉ</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>Appareil&#xa0;: %1</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Lock (%1)</source>
        <translation>Verrouiller (%1)</translation>
    </message>
    <message>
        <source>Closes the window&apos;s pages until somebody logs in (F12)</source>
        <translation>Ferme les pages de la fenêtre jusqu’à ce que quelqu’un se connecte (F12)</translation>
    </message>
    <message>
        <source>What is measured comes from software or a file, not from a person here</source>
        <translation>Ce qui est mesuré vient d’un logiciel ou d’un fichier, pas d’une personne ici</translation>
    </message>
    <message>
        <source>Cameras: %1</source>
        <translation>Caméras&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Caméras</translation>
    </message>
    <message>
        <source>Tracker: %1</source>
        <translation>Suivi de la main&#xa0;: %1</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Suivi</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TreatmentCard</name>
    <message>
        <source>Treatment</source>
        <translation>Traitement</translation>
    </message>
    <message>
        <source>Day of the treatment</source>
        <translation>Jour du traitement</translation>
    </message>
    <message>
        <source>Kind of treatment</source>
        <translation>Type de traitement</translation>
    </message>
    <message>
        <source>Kind of treatment (Alt+Down shows all)</source>
        <translation>Type de traitement (Alt+Bas les montre tous)</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Ce qui a été fait</translation>
    </message>
    <message>
        <source>Muscles, dose, what changed</source>
        <translation>Muscles, dose, changement</translation>
    </message>
    <message>
        <source>Add this treatment</source>
        <translation>Ajouter ce traitement</translation>
    </message>
    <message>
        <source>Treatments</source>
        <translation>Traitements</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>No treatment is entered. What changed, and when, helps to read the trends.</source>
        <translation>Aucun traitement n’est saisi. Ce qui a changé, et quand, aide à lire les évolutions.</translation>
    </message>
    <message>
        <source>New treatment</source>
        <translation>Nouveau traitement</translation>
    </message>
    <message>
        <source>Not added. %1</source>
        <translation>Non ajouté. %1</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrendGrid</name>
    <message>
        <source>No measure of this patient has been stored yet.</source>
        <translation>Aucune mesure n’est encore enregistrée pour ce patient.</translation>
    </message>
    <message>
        <source>All measures</source>
        <translation>Toutes les mesures</translation>
    </message>
    <message>
        <source>Back to all measures (Escape, or F4)</source>
        <translation>Retour à toutes les mesures (Échap, ou F4)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1. Without a value: %2.</source>
        <translation>%1. Sans valeur&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1
The trials differ in their parameters, level or object, so that not only the patient changes from one to the next.</source>
        <translation>%1
Les essais diffèrent par leurs paramètres, leur niveau ou l’objet&#xa0;: de l’un à l’autre, le patient n’est pas seul à changer.</translation>
    </message>
    <message>
        <source>Disc: assessment, ring: practice, triangle: helped; the line joins the means of the sessions (Escape goes back)</source>
        <translation>Disque&#xa0;: bilan, anneau&#xa0;: entraînement, triangle&#xa0;: aidé&#xa0;; la ligne joint les moyennes des séances (Échap revient)</translation>
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
        <translation>Essai</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrendTile</name>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2&#xa0;: %3</translation>
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
Dernière valeur %3.%4 Les flèches passent à l’image suivante, Entrée ou un clic agrandit celle-ci (F4)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrialAbout</name>
    <message>
        <source>Why it was held and let go</source>
        <translation>Pourquoi tenu, pourquoi lâché</translation>
    </message>
    <message>
        <source>About this trial</source>
        <translation>À propos de cet essai</translation>
    </message>
    <message>
        <source>Measures, events and what is known: arrow keys; Enter on an event goes there</source>
        <translation>Mesures, événements et ce que l’on sait&#xa0;: flèches&#xa0;; Entrée sur un événement y mène</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
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
        <translation>Mesures</translation>
    </message>
    <message>
        <source>About</source>
        <translation>À propos</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>Other measures</source>
        <translation>Autres mesures</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrialPlot</name>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>several units</source>
        <translation>plusieurs unités</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::TrialView</name>
    <message>
        <source>Trial</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Ce qui est tracé</translation>
    </message>
    <message>
        <source>What is drawn over time: arrow keys choose (Ctrl+G)</source>
        <translation>Ce qui est tracé dans le temps&#xa0;: choisir avec les flèches (Ctrl+G)</translation>
    </message>
    <message>
        <source>Choose a trial at the left and open it with Enter.</source>
        <translation>Choisissez un essai à gauche et ouvrez-le avec Entrée.</translation>
    </message>
    <message>
        <source>Path of the object</source>
        <translation>Trajet de l’objet</translation>
    </message>
    <message>
        <source>Path, object and target (dashed); filled dots are fingers that touch</source>
        <translation>Trajet, objet et cible (pointillé)&#xa0;; points pleins&#xa0;: doigts en contact</translation>
    </message>
    <message>
        <source>Drawn flat: this display has no OpenGL for the 3D picture.</source>
        <translation>Dessin à plat&#xa0;: cet affichage n’a pas OpenGL pour l’image 3D.</translation>
    </message>
    <message>
        <source>Signals of the trial</source>
        <translation>Signaux de l’essai</translation>
    </message>
    <message>
        <source>Left and right arrow keys step by a sample (with Shift by ten), up and down zoom, Space plays; the mouse moves the cursor, a double click shows all (F6)</source>
        <translation>Les flèches gauche et droite avancent d’un échantillon (dix avec Maj), haut et bas zooment, Espace lit&#xa0;; la souris déplace le curseur, un double clic montre tout (F6)</translation>
    </message>
    <message>
        <source>Recorded channels</source>
        <translation>Voies enregistrées</translation>
    </message>
    <message>
        <source>Every recorded channel: arrow keys and Space choose what is drawn</source>
        <translation>Toutes les voies enregistrées&#xa0;: flèches et Espace choisissent ce qui est tracé</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Lire ou arrêter</translation>
    </message>
    <message>
        <source>Play or pause the replay (Space)</source>
        <translation>Lancer ou arrêter la relecture (Espace)</translation>
    </message>
    <message>
        <source>Time in the trial</source>
        <translation>Temps dans l’essai</translation>
    </message>
    <message>
        <source>Time in the trial: arrow keys 0.1 s, page keys 1 s, Home and End; Space plays</source>
        <translation>Temps dans l’essai&#xa0;: flèches 0,1 s, pages 1 s, Début et Fin&#xa0;; Espace lit</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Vitesse de relecture</translation>
    </message>
    <message>
        <source>Speed of the replay (keys + and −)</source>
        <translation>Vitesse de relecture (touches + et −)</translation>
    </message>
    <message>
        <source>Loading %1 …</source>
        <translation>Chargement&#xa0;: %1 …</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>Essai %1&#xa0;: %2</translation>
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
        <translation>Objet</translation>
    </message>
    <message>
        <source>The object as the patient saw it, and its path (Space)</source>
        <translation>L’objet tel que le patient l’a vu, et son trajet (Espace)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 sur %2 s</translation>
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
        <translation>cibles atteintes %1</translation>
    </message>
    <message>
        <source>%L1 ×</source>
        <translation>%L1 ×</translation>
    </message>
    <message>
        <source>Picture of both hands</source>
        <translation>Image des deux mains</translation>
    </message>
    <message>
        <source>What the patient saw: the force of each hand and what was asked (Space)</source>
        <translation>Ce que le patient a vu&#xa0;: la force de chaque main et ce qui était demandé (espace)</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::VisitCard</name>
    <message>
        <source>tasks one by one</source>
        <translation>tâches une à une</translation>
    </message>
    <message>
        <source>TODAY</source>
        <translation>AUJOURD’HUI</translation>
    </message>
    <message>
        <source>USUAL DAY</source>
        <translation>JOUR HABITUEL</translation>
    </message>
    <message>
        <source>Unfinished since %1: %2</source>
        <translation>Inachevé depuis %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Ensuite&#xa0;: %1</translation>
    </message>
    <message>
        <source>Next: first session</source>
        <translation>Ensuite&#xa0;: première séance</translation>
    </message>
    <message>
        <source>Last session %1, %2</source>
        <translation>Dernière séance %1, %2</translation>
    </message>
    <message>
        <source>No session yet; added %1</source>
        <translation>Pas encore de séance&#xa0;; ajouté le %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Begin a session with %1</source>
        <translation>Commencer une séance avec %1</translation>
    </message>
    <message>
        <source>Enter on the card begins, too</source>
        <translation>Entrée sur la carte commence aussi</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>Sessions, measures and trials so far (Ctrl+2)</source>
        <translation>Séances, mesures et essais jusqu’ici (Ctrl+2)</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Added by mistake: nothing is stored of this person; the log keeps that it was removed</source>
        <translation>Ajouté par erreur&#xa0;: rien n’est enregistré de cette personne&#xa0;; le journal garde la trace du retrait</translation>
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
        <translation>Ce qui en est déjà écrit</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ZeroForm</name>
    <message>
        <source>Device is empty: set &amp;zero</source>
        <translation>Appareil vide&#xa0;: mise à &amp;zéro</translation>
    </message>
    <message>
        <source>Set the zero of the empty device</source>
        <translation>Mise à zéro de l’appareil vide</translation>
    </message>
    <message>
        <source>With no hand in the device: one quiet second becomes zero (Alt+Z)</source>
        <translation>Sans main dans l’appareil&#xa0;: une seconde calme devient le zéro (Alt+Z)</translation>
    </message>
    <message>
        <source>Empty; was serviced: ta&amp;ke it</source>
        <translation>Vide, rév&amp;isé&#xa0;: accepter</translation>
    </message>
    <message>
        <source>The device was serviced or remounted: accept its new zero</source>
        <translation>L’appareil a été révisé ou remonté&#xa0;: accepter son nouveau zéro</translation>
    </message>
    <message>
        <source>The empty device reads something else than at its last zero because it was serviced or remounted; this is stored with the zero (Alt+K)</source>
        <translation>L’appareil vide indique autre chose qu’à son dernier zéro parce qu’il a été révisé ou remonté&#xa0;; c’est enregistré avec le zéro (Alt+I)</translation>
    </message>
    <message>
        <source>Measuring the empty device</source>
        <translation>Mesure de l’appareil vide</translation>
    </message>
    <message>
        <source>Both are empty: set &amp;zeros</source>
        <translation>Les deux vides&#xa0;: mise à &amp;zéro</translation>
    </message>
    <message>
        <source>Set the zeros of both empty platforms</source>
        <translation>Mise à zéro des deux plateformes vides</translation>
    </message>
    <message>
        <source>With no hand in either: one quiet second becomes zero, of both at once (Alt+Z)</source>
        <translation>Sans main dans aucune&#xa0;: une seconde calme devient zéro, des deux à la fois (Alt+Z)</translation>
    </message>
    <message>
        <source>No hand in either, nothing touches the supports.</source>
        <translation>Aucune main dans l’une ni l’autre, rien ne touche les supports.</translation>
    </message>
    <message>
        <source>No hand, nothing touches the supports.</source>
        <translation>Pas de main, rien ne touche les supports.</translation>
    </message>
</context>
</TS>
