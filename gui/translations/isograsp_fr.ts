<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
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
        <translation>%1 glisse : plus de force vers l’objet, moins le long de l’objet.</translation>
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
</context>
<context>
    <name>Flow</name>
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
        <source>The protocol is finished. Write the report, or disconnect to end.</source>
        <translation>Le protocole est terminé. Rédigez le rapport, ou déconnectez pour finir.</translation>
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
        <translation>Posez les questions préalables avant tout effort.</translation>
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
        <source>Choose the device.</source>
        <translation>Choisissez l’appareil.</translation>
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
        <translation>L’appareil fonctionne de nouveau. La main relâche ; si « Reprendre » reste fermé, arrêter, mettre à zéro et répéter l’essai.</translation>
    </message>
    <message>
        <source>The straps have been on for 20 minutes: look at the skin, then confirm that the hand is in and strapped.</source>
        <translation>Les sangles sont en place depuis 20 minutes : regardez la peau, puis confirmez que la main est en place et sanglée.</translation>
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
        <source>Held firmly by</source>
        <translation>Tenu fermement par</translation>
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
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Forces act in</source>
        <translation>Les forces agissent dans</translation>
    </message>
    <message>
        <source>Grasp rule</source>
        <translation>Règle de prise</translation>
    </message>
    <message>
        <source>Limits of travel</source>
        <translation>Limites de course</translation>
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
</context>
<context>
    <name>NextWords</name>
    <message>
        <source>%1, practice</source>
        <translation>%1, entraînement</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <translation>%1 (%2 sur %3)</translation>
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
        <source>Relax your hand.</source>
        <translation>Détendez la main.</translation>
    </message>
    <message>
        <source>Please take your hand out of the device</source>
        <translation>Retirez la main de l’appareil</translation>
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
</context>
<context>
    <name>QObject</name>
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
        <source>Resting force, %1</source>
        <translation>Force de repos, %1</translation>
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
    <name>Texts</name>
    <message>
        <source>this folder does not exist</source>
        <translation>ce dossier n’existe pas</translation>
    </message>
    <message>
        <source>choose another folder, or make it first</source>
        <translation>choisir un autre dossier, ou le créer d’abord</translation>
    </message>
    <message>
        <source>this is no folder</source>
        <translation>ce n’est pas un dossier</translation>
    </message>
    <message>
        <source>nothing may be written into this folder</source>
        <translation>rien ne peut être écrit dans ce dossier</translation>
    </message>
    <message>
        <source>choose another folder, or ask for the permission</source>
        <translation>choisir un autre dossier, ou demander le droit d’écrire</translation>
    </message>
    <message>
        <source>check its number and that of its session</source>
        <translation>vérifier son numéro et celui de sa séance</translation>
    </message>
    <message>
        <source>correcting a rating</source>
        <translation>correction d’une évaluation</translation>
    </message>
    <message>
        <source>rating %1 does not exist</source>
        <translation>l’évaluation %1 n’existe pas</translation>
    </message>
    <message>
        <source> at %1 %</source>
        <translation> à %1 %</translation>
    </message>
    <message>
        <source> at %1 Hz</source>
        <translation> à %1 Hz</translation>
    </message>
    <message>
        <source> at %1 N</source>
        <translation> à %1 N</translation>
    </message>
    <message>
        <source> of the force</source>
        <translation> de la force</translation>
    </message>
    <message>
        <source> target %1</source>
        <translation> cible %1</translation>
    </message>
    <message>
        <source>%1 KiB</source>
        <translation>%1 Kio</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 Mio</translation>
    </message>
    <message>
        <source>, all digits</source>
        <translation>, tous les doigts</translation>
    </message>
    <message>
        <source>, all digits opening</source>
        <translation>, tous les doigts en ouverture</translation>
    </message>
    <message>
        <source>, all digits toward +x</source>
        <translation>, tous les doigts vers +x</translation>
    </message>
    <message>
        <source>, all digits toward +y</source>
        <translation>, tous les doigts vers +y</translation>
    </message>
    <message>
        <source>, all digits toward -x</source>
        <translation>, tous les doigts vers -x</translation>
    </message>
    <message>
        <source>, all digits toward -y</source>
        <translation>, tous les doigts vers -y</translation>
    </message>
    <message>
        <source>, building up</source>
        <translation>, montée</translation>
    </message>
    <message>
        <source>, grip toward +x</source>
        <translation>, prise vers +x</translation>
    </message>
    <message>
        <source>, grip toward +y</source>
        <translation>, prise vers +y</translation>
    </message>
    <message>
        <source>, grip toward -x</source>
        <translation>, prise vers -x</translation>
    </message>
    <message>
        <source>, grip toward -y</source>
        <translation>, prise vers -y</translation>
    </message>
    <message>
        <source>, holding</source>
        <translation>, maintien</translation>
    </message>
    <message>
        <source>, index</source>
        <translation>, index</translation>
    </message>
    <message>
        <source>, index opening</source>
        <translation>, index en ouverture</translation>
    </message>
    <message>
        <source>, index toward +x</source>
        <translation>, index vers +x</translation>
    </message>
    <message>
        <source>, index toward +y</source>
        <translation>, index vers +y</translation>
    </message>
    <message>
        <source>, index toward -x</source>
        <translation>, index vers -x</translation>
    </message>
    <message>
        <source>, index toward -y</source>
        <translation>, index vers -y</translation>
    </message>
    <message>
        <source>, index while middle presses</source>
        <translation>, index pendant que le majeur appuie</translation>
    </message>
    <message>
        <source>, index while thumb presses</source>
        <translation>, index pendant que le pouce appuie</translation>
    </message>
    <message>
        <source>, letting down</source>
        <translation>, descente</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers</source>
        <translation>, moyenne du pouce et des doigts</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers opening</source>
        <translation>, moyenne du pouce et des doigts en ouverture</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward +x</source>
        <translation>, moyenne du pouce et des doigts vers +x</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward +y</source>
        <translation>, moyenne du pouce et des doigts vers +y</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward -x</source>
        <translation>, moyenne du pouce et des doigts vers -x</translation>
    </message>
    <message>
        <source>, mean of thumb and fingers toward -y</source>
        <translation>, moyenne du pouce et des doigts vers -y</translation>
    </message>
    <message>
        <source>, middle</source>
        <translation>, majeur</translation>
    </message>
    <message>
        <source>, middle opening</source>
        <translation>, majeur en ouverture</translation>
    </message>
    <message>
        <source>, middle toward +x</source>
        <translation>, majeur vers +x</translation>
    </message>
    <message>
        <source>, middle toward +y</source>
        <translation>, majeur vers +y</translation>
    </message>
    <message>
        <source>, middle toward -x</source>
        <translation>, majeur vers -x</translation>
    </message>
    <message>
        <source>, middle toward -y</source>
        <translation>, majeur vers -y</translation>
    </message>
    <message>
        <source>, middle while index presses</source>
        <translation>, majeur pendant que l’index appuie</translation>
    </message>
    <message>
        <source>, middle while thumb presses</source>
        <translation>, majeur pendant que le pouce appuie</translation>
    </message>
    <message>
        <source>, opening</source>
        <translation>, ouverture</translation>
    </message>
    <message>
        <source>, thumb</source>
        <translation>, pouce</translation>
    </message>
    <message>
        <source>, thumb and index</source>
        <translation>, pouce et index</translation>
    </message>
    <message>
        <source>, thumb and index opening</source>
        <translation>, pouce et index en ouverture</translation>
    </message>
    <message>
        <source>, thumb and index toward +x</source>
        <translation>, pouce et index vers +x</translation>
    </message>
    <message>
        <source>, thumb and index toward +y</source>
        <translation>, pouce et index vers +y</translation>
    </message>
    <message>
        <source>, thumb and index toward -x</source>
        <translation>, pouce et index vers -x</translation>
    </message>
    <message>
        <source>, thumb and index toward -y</source>
        <translation>, pouce et index vers -y</translation>
    </message>
    <message>
        <source>, thumb opening</source>
        <translation>, pouce en ouverture</translation>
    </message>
    <message>
        <source>, thumb toward +x</source>
        <translation>, pouce vers +x</translation>
    </message>
    <message>
        <source>, thumb toward +y</source>
        <translation>, pouce vers +y</translation>
    </message>
    <message>
        <source>, thumb toward -x</source>
        <translation>, pouce vers -x</translation>
    </message>
    <message>
        <source>, thumb toward -y</source>
        <translation>, pouce vers -y</translation>
    </message>
    <message>
        <source>, thumb while index presses</source>
        <translation>, pouce pendant que l’index appuie</translation>
    </message>
    <message>
        <source>, thumb while middle presses</source>
        <translation>, pouce pendant que le majeur appuie</translation>
    </message>
    <message>
        <source>, turn about x</source>
        <translation>, rotation selon x</translation>
    </message>
    <message>
        <source>, turn about y</source>
        <translation>, rotation selon y</translation>
    </message>
    <message>
        <source>, turn about z</source>
        <translation>, rotation selon z</translation>
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
        <translation>Un capteur n’est pas le bon&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>A sensor is overloaded: take the hand out.</source>
        <translation>Un capteur est surchargé&#xa0;: retirez la main.</translation>
    </message>
    <message>
        <source>A sensor is silent: check its cable and power.</source>
        <translation>Un capteur ne répond pas&#xa0;: vérifiez son câble et son alimentation.</translation>
    </message>
    <message>
        <source>A sensor loses samples on the way: check the bus wiring.</source>
        <translation>Un capteur perd des échantillons en route&#xa0;: vérifiez le câblage du bus.</translation>
    </message>
    <message>
        <source>A sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Un capteur répète une valeur&#xa0;: éteignez-le, rallumez-le, puis refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>A sensor reports that it is broken: do not measure with it.</source>
        <translation>Un capteur signale qu’il est en panne&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>A sensor started anew: take the hand out and zero again.</source>
        <translation>Un capteur a redémarré&#xa0;: retirez la main et refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>Answers before the cue could be seen</source>
        <translation>Réponses avant que le signal soit visible</translation>
    </message>
    <message>
        <source>At rest thumb %1, index %2, middle %3 N.</source>
        <translation>Au repos pouce %1, index %2, majeur %3 N.</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Batterie</translation>
    </message>
    <message>
        <source>Battery, core</source>
        <translation>Batterie, noyau</translation>
    </message>
    <message>
        <source>Bring the block to its outline as fast as you can and hold it still for a moment.</source>
        <translation>Amenez le bloc à son contour aussi vite que possible et tenez-le immobile un instant.</translation>
    </message>
    <message>
        <source>Bring the block to its outline, slowly and level. Turn it there and hold it still.</source>
        <translation>Amenez le bloc à son contour, lentement et bien droit. Tournez-le là et tenez-le immobile.</translation>
    </message>
    <message>
        <source>CV of the empty device</source>
        <translation>CV de l’appareil vide</translation>
    </message>
    <message>
        <source>Check that nothing leans on the finger support; if it is free, the sensor may be damaged.</source>
        <translation>Vérifiez que rien ne s’appuie sur l’appui du doigt&#xa0;; s’il est libre, le capteur est peut-être endommagé.</translation>
    </message>
    <message>
        <source>Close and open</source>
        <translation>Fermer et ouvrir</translation>
    </message>
    <message>
        <source>Closing-opening profile</source>
        <translation>Profil fermeture-ouverture</translation>
    </message>
    <message>
        <source>Comfortable force above rest</source>
        <translation>Force confortable au-dessus du repos</translation>
    </message>
    <message>
        <source>Comfortable force, total</source>
        <translation>Force confortable, totale</translation>
    </message>
    <message>
        <source>Comfortable grip above rest</source>
        <translation>Prise confortable au-dessus du repos</translation>
    </message>
    <message>
        <source>Comfortable grip force</source>
        <translation>Force de préhension confortable</translation>
    </message>
    <message>
        <source>Comfortable grip, total</source>
        <translation>Prise confortable, totale</translation>
    </message>
    <message>
        <source>Constant error</source>
        <translation>Erreur constante</translation>
    </message>
    <message>
        <source>Correct quaternion_wxyz in the device file.</source>
        <translation>Corrigez quaternion_wxyz dans le fichier de l’appareil.</translation>
    </message>
    <message>
        <source>Correct quaternion_wxyz or sign in the device file.</source>
        <translation>Corrigez quaternion_wxyz ou sign dans le fichier de l’appareil.</translation>
    </message>
    <message>
        <source>Coupling of grip and load (virtual)</source>
        <translation>Couplage prise-charge (virtuel)</translation>
    </message>
    <message>
        <source>Cues answered</source>
        <translation>Signaux suivis d’une réponse</translation>
    </message>
    <message>
        <source>Cues to let go answered</source>
        <translation>Signaux de relâchement suivis</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Démonstration</translation>
    </message>
    <message>
        <source>Detour of the forces</source>
        <translation>Détour des forces</translation>
    </message>
    <message>
        <source>Detour of the grips</source>
        <translation>Détour des prises</translation>
    </message>
    <message>
        <source>Direction error</source>
        <translation>Erreur de direction</translation>
    </message>
    <message>
        <source>Directness of the path</source>
        <translation>Rectitude du trajet</translation>
    </message>
    <message>
        <source>Distance outside the corridor (RMS)</source>
        <translation>Distance hors du couloir (RMS)</translation>
    </message>
    <message>
        <source>Distance outside the corridor (mean)</source>
        <translation>Distance hors du couloir (moyenne)</translation>
    </message>
    <message>
        <source>Do not measure with it: have it calibrated.</source>
        <translation>Ne mesurez pas avec&#xa0;: faites-le étalonner.</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Chutes</translation>
    </message>
    <message>
        <source>Elastic block</source>
        <translation>Bloc élastique</translation>
    </message>
    <message>
        <source>Endurance</source>
        <translation>Endurance</translation>
    </message>
    <message>
        <source>Error of the force from memory</source>
        <translation>Erreur de la force de mémoire</translation>
    </message>
    <message>
        <source>Error of the grip from memory</source>
        <translation>Erreur de la prise de mémoire</translation>
    </message>
    <message>
        <source>Exchange their cables or their entries in the device file.</source>
        <translation>Échangez leurs câbles ou leurs entrées dans le fichier de l’appareil.</translation>
    </message>
    <message>
        <source>Fading of the force</source>
        <translation>Baisse de la force</translation>
    </message>
    <message>
        <source>Fading of the grip</source>
        <translation>Baisse de la prise</translation>
    </message>
    <message>
        <source>Fall of the held force</source>
        <translation>Chute de la force maintenue</translation>
    </message>
    <message>
        <source>Fall of the held grip</source>
        <translation>Chute de la prise maintenue</translation>
    </message>
    <message>
        <source>Familiarisation</source>
        <translation>Familiarisation</translation>
    </message>
    <message>
        <source>Fastest release</source>
        <translation>Relâchement le plus rapide</translation>
    </message>
    <message>
        <source>Fastest rise of force</source>
        <translation>Montée de force la plus rapide</translation>
    </message>
    <message>
        <source>Fastest rise of grip</source>
        <translation>Montée de prise la plus rapide</translation>
    </message>
    <message>
        <source>Fatigue</source>
        <translation>Fatigue</translation>
    </message>
    <message>
        <source>Feel this force. Then make the same force again without seeing it.</source>
        <translation>Sentez cette force. Puis refaites la même force sans la voir.</translation>
    </message>
    <message>
        <source>Follow and turn</source>
        <translation>Suivre et tourner</translation>
    </message>
    <message>
        <source>Follow sideways</source>
        <translation>Suivre de côté</translation>
    </message>
    <message>
        <source>Follow the arrow: press, pull or push sideways as hard as you can, then relax.</source>
        <translation>Suivez la flèche&#xa0;: appuyez, tirez ou poussez de côté aussi fort que possible, puis détendez.</translation>
    </message>
    <message>
        <source>Follow the target up and down, as fast as it jumps.</source>
        <translation>Suivez la cible en haut et en bas, aussi vite qu’elle saute.</translation>
    </message>
    <message>
        <source>Force direction</source>
        <translation>Direction de la force</translation>
    </message>
    <message>
        <source>Force left 5 s after the cue</source>
        <translation>Force restante 5 s après le signal</translation>
    </message>
    <message>
        <source>Force of a digit that was not asked</source>
        <translation>Force d’un doigt non demandé</translation>
    </message>
    <message>
        <source>Force sense</source>
        <translation>Sens de la force</translation>
    </message>
    <message>
        <source>Free handling</source>
        <translation>Manipulation libre</translation>
    </message>
    <message>
        <source>Friction used (virtual)</source>
        <translation>Friction utilisée (virtuelle)</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Good: the index finger&apos;s support felt %1 N.</source>
        <translation>Bien&#xa0;: l’appui de l’index a senti %1 N.</translation>
    </message>
    <message>
        <source>Good: the middle finger&apos;s support felt %1 N.</source>
        <translation>Bien&#xa0;: l’appui du majeur a senti %1 N.</translation>
    </message>
    <message>
        <source>Good: the thumb&apos;s support felt %1 N.</source>
        <translation>Bien&#xa0;: l’appui du pouce a senti %1 N.</translation>
    </message>
    <message>
        <source>Grip and let go</source>
        <translation>Serrer et relâcher</translation>
    </message>
    <message>
        <source>Grip force, own target</source>
        <translation>Force de préhension, cible propre</translation>
    </message>
    <message>
        <source>Grip force, ramp</source>
        <translation>Force de préhension, rampe</translation>
    </message>
    <message>
        <source>Grip force, random, new each time</source>
        <translation>Force de préhension, aléatoire, toujours nouvelle</translation>
    </message>
    <message>
        <source>Grip force, random, the same each time</source>
        <translation>Force de préhension, aléatoire, toujours la même</translation>
    </message>
    <message>
        <source>Grip force, rectangle</source>
        <translation>Force de préhension, créneau</translation>
    </message>
    <message>
        <source>Grip force, several sines</source>
        <translation>Force de préhension, plusieurs sinus</translation>
    </message>
    <message>
        <source>Grip force, sine</source>
        <translation>Force de préhension, sinus</translation>
    </message>
    <message>
        <source>Grip force, sine, comfortable</source>
        <translation>Force de préhension, sinus, confortable</translation>
    </message>
    <message>
        <source>Grip force, sine, fixed load</source>
        <translation>Force de préhension, sinus, charge fixe</translation>
    </message>
    <message>
        <source>Grip force, sine, short</source>
        <translation>Force de préhension, sinus, court</translation>
    </message>
    <message>
        <source>Grip force, sine, without feedback</source>
        <translation>Force de préhension, sinus, sans retour</translation>
    </message>
    <message>
        <source>Grip force, swept sine</source>
        <translation>Force de préhension, sinus balayé</translation>
    </message>
    <message>
        <source>Grip force, trapezoid</source>
        <translation>Force de préhension, trapèze</translation>
    </message>
    <message>
        <source>Grip force, triangle</source>
        <translation>Force de préhension, triangle</translation>
    </message>
    <message>
        <source>Grip per load (virtual)</source>
        <translation>Prise par charge (virtuelle)</translation>
    </message>
    <message>
        <source>Grip the block, carry it to its outline, hold it there and let go when told.</source>
        <translation>Saisissez le bloc, portez-le à son contour, tenez-le là et relâchez au signal.</translation>
    </message>
    <message>
        <source>Grip the weight, lift it to its outline and hold it still there.</source>
        <translation>Saisissez le poids, levez-le à son contour et tenez-le là immobile.</translation>
    </message>
    <message>
        <source>Grip training, sine</source>
        <translation>Entraînement de la prise, sinus</translation>
    </message>
    <message>
        <source>Hardest effort, of the maximum force</source>
        <translation>Effort le plus fort, de la force maximale</translation>
    </message>
    <message>
        <source>Hardest effort, of the maximum grip</source>
        <translation>Effort le plus fort, de la prise maximale</translation>
    </message>
    <message>
        <source>Hold error, angle</source>
        <translation>Erreur de maintien, angle</translation>
    </message>
    <message>
        <source>Hold error, main axis</source>
        <translation>Erreur de maintien, axe principal</translation>
    </message>
    <message>
        <source>Hold error, position</source>
        <translation>Erreur de maintien, position</translation>
    </message>
    <message>
        <source>Hold the line as long as it stays, up to half a minute.</source>
        <translation>Tenez la ligne tant qu’elle reste, jusqu’à une demi-minute.</translation>
    </message>
    <message>
        <source>Hold the target. When the screen says let go: let go at once.</source>
        <translation>Tenez la cible. Quand l’écran dit «&#xa0;Relâchez&#xa0;»&#xa0;: relâchez aussitôt.</translation>
    </message>
    <message>
        <source>Hold the target. When the screen says open: open your hand at once.</source>
        <translation>Tenez la cible. Quand l’écran dit «&#xa0;Ouvrez&#xa0;»&#xa0;: ouvrez aussitôt la main.</translation>
    </message>
    <message>
        <source>If nothing leans on the supports, the sensor may be damaged.</source>
        <translation>Si rien ne s’appuie sur les appuis, le capteur est peut-être endommagé.</translation>
    </message>
    <message>
        <source>If the device was serviced or remounted since, confirm that.</source>
        <translation>Si l’appareil a été révisé ou remonté depuis, confirmez-le.</translation>
    </message>
    <message>
        <source>Impulse of the grip</source>
        <translation>Impulsion de la prise</translation>
    </message>
    <message>
        <source>Index finger, sine</source>
        <translation>Index, sinus</translation>
    </message>
    <message>
        <source>Index of difficulty</source>
        <translation>Indice de difficulté</translation>
    </message>
    <message>
        <source>Instrument zero</source>
        <translation>Mise à zéro de l’appareil</translation>
    </message>
    <message>
        <source>It differs from the last empty zero by %1 N; confirmed as serviced or remounted.</source>
        <translation>Il diffère de %1 N du dernier zéro à vide&#xa0;; confirmé comme révisé ou remonté.</translation>
    </message>
    <message>
        <source>It is kept as it is and never subtracted.</source>
        <translation>Elle est conservée telle quelle et jamais soustraite.</translation>
    </message>
    <message>
        <source>It was the index finger&apos;s support that felt this: the sensors of middle and index are swapped.</source>
        <translation>C’est l’appui de l’index qui l’a senti&#xa0;: les capteurs du majeur et de l’index sont intervertis.</translation>
    </message>
    <message>
        <source>It was the index finger&apos;s support that felt this: the sensors of thumb and index are swapped.</source>
        <translation>C’est l’appui de l’index qui l’a senti&#xa0;: les capteurs du pouce et de l’index sont intervertis.</translation>
    </message>
    <message>
        <source>It was the middle finger&apos;s support that felt this: the sensors of index and middle are swapped.</source>
        <translation>C’est l’appui du majeur qui l’a senti&#xa0;: les capteurs de l’index et du majeur sont intervertis.</translation>
    </message>
    <message>
        <source>It was the middle finger&apos;s support that felt this: the sensors of thumb and middle are swapped.</source>
        <translation>C’est l’appui du majeur qui l’a senti&#xa0;: les capteurs du pouce et du majeur sont intervertis.</translation>
    </message>
    <message>
        <source>It was the thumb&apos;s support that felt this: the sensors of index and thumb are swapped.</source>
        <translation>C’est l’appui du pouce qui l’a senti&#xa0;: les capteurs de l’index et du pouce sont intervertis.</translation>
    </message>
    <message>
        <source>It was the thumb&apos;s support that felt this: the sensors of middle and thumb are swapped.</source>
        <translation>C’est l’appui du pouce qui l’a senti&#xa0;: les capteurs du majeur et du pouce sont intervertis.</translation>
    </message>
    <message>
        <source>Jumping target</source>
        <translation>Cible sautante</translation>
    </message>
    <message>
        <source>Lag behind the target</source>
        <translation>Retard sur la cible</translation>
    </message>
    <message>
        <source>Lag from the phase</source>
        <translation>Retard d’après la phase</translation>
    </message>
    <message>
        <source>Lag of the grip behind the load</source>
        <translation>Retard de la prise sur la charge</translation>
    </message>
    <message>
        <source>Lag without the device&apos;s delay</source>
        <translation>Retard sans celui de l’appareil</translation>
    </message>
    <message>
        <source>Learning study</source>
        <translation>Étude d’apprentissage</translation>
    </message>
    <message>
        <source>Leave your hand in the device. Let it rest. Do nothing.</source>
        <translation>Laissez la main dans l’appareil. Laissez-la au repos. Ne faites rien.</translation>
    </message>
    <message>
        <source>Let go, short</source>
        <translation>Relâcher, court</translation>
    </message>
    <message>
        <source>Lift a weight</source>
        <translation>Lever un poids</translation>
    </message>
    <message>
        <source>Maximum force above rest</source>
        <translation>Force maximale au-dessus du repos</translation>
    </message>
    <message>
        <source>Maximum force, index finger</source>
        <translation>Force maximale, index</translation>
    </message>
    <message>
        <source>Maximum force, mean over a fixed window</source>
        <translation>Force maximale, moyenne sur une fenêtre fixe</translation>
    </message>
    <message>
        <source>Maximum force, middle finger</source>
        <translation>Force maximale, majeur</translation>
    </message>
    <message>
        <source>Maximum force, thumb</source>
        <translation>Force maximale, pouce</translation>
    </message>
    <message>
        <source>Maximum force, total</source>
        <translation>Force maximale, totale</translation>
    </message>
    <message>
        <source>Maximum grip above rest</source>
        <translation>Prise maximale au-dessus du repos</translation>
    </message>
    <message>
        <source>Maximum grip force</source>
        <translation>Force maximale de préhension</translation>
    </message>
    <message>
        <source>Maximum grip, mean over a fixed window</source>
        <translation>Prise maximale, moyenne sur une fenêtre fixe</translation>
    </message>
    <message>
        <source>Maximum grip, total</source>
        <translation>Prise maximale, totale</translation>
    </message>
    <message>
        <source>Maximum pinch force</source>
        <translation>Force maximale de pince</translation>
    </message>
    <message>
        <source>Mean force</source>
        <translation>Force moyenne</translation>
    </message>
    <message>
        <source>Mean grip</source>
        <translation>Prise moyenne</translation>
    </message>
    <message>
        <source>Mean length of a pause</source>
        <translation>Durée moyenne d’une pause</translation>
    </message>
    <message>
        <source>Mean time, misses at the limit</source>
        <translation>Temps moyen, échecs à la limite</translation>
    </message>
    <message>
        <source>Median time to reach</source>
        <translation>Temps médian d’atteinte</translation>
    </message>
    <message>
        <source>Move the block as you like.</source>
        <translation>Déplacez le bloc comme vous voulez.</translation>
    </message>
    <message>
        <source>No sensor felt a press.</source>
        <translation>Aucun capteur n’a senti d’appui.</translation>
    </message>
    <message>
        <source>Open on cue</source>
        <translation>Ouvrir au signal</translation>
    </message>
    <message>
        <source>Opening force</source>
        <translation>Force d’ouverture</translation>
    </message>
    <message>
        <source>Opening force, index finger</source>
        <translation>Force d’ouverture, index</translation>
    </message>
    <message>
        <source>Opening force, middle finger</source>
        <translation>Force d’ouverture, majeur</translation>
    </message>
    <message>
        <source>Opening force, thumb</source>
        <translation>Force d’ouverture, pouce</translation>
    </message>
    <message>
        <source>Opening grip</source>
        <translation>Prise en ouverture</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>Pain %1 of %2, %3 more than at first: stop the work of this hand for today.</source>
        <translation>Douleur %1 sur %2, %3 de plus qu’au début&#xa0;: arrêtez le travail de cette main pour aujourd’hui.</translation>
    </message>
    <message>
        <source>Pain %1 of %2: stop the work of this hand for today.</source>
        <translation>Douleur %1 sur %2&#xa0;: arrêtez le travail de cette main pour aujourd’hui.</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longueur du trajet</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Paused by the therapist.</source>
        <translation>Mis en pause par le thérapeute.</translation>
    </message>
    <message>
        <source>Paused: samples are missing. Check the cables, check the zero, then resume.</source>
        <translation>En pause&#xa0;: des échantillons manquent. Vérifiez les câbles et le zéro, puis reprenez.</translation>
    </message>
    <message>
        <source>Paused: the device has a fault. Mend it, check the zero, then resume.</source>
        <translation>En pause&#xa0;: l’appareil a un défaut. Corrigez-le, vérifiez le zéro, puis reprenez.</translation>
    </message>
    <message>
        <source>Pauses on the ramp</source>
        <translation>Pauses sur la rampe</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Force de pointe</translation>
    </message>
    <message>
        <source>Peak grip</source>
        <translation>Prise de pointe</translation>
    </message>
    <message>
        <source>Phase of the answer</source>
        <translation>Phase de la réponse</translation>
    </message>
    <message>
        <source>Pick and place</source>
        <translation>Prendre et poser</translation>
    </message>
    <message>
        <source>Pinch force, sine</source>
        <translation>Force de pince, sinus</translation>
    </message>
    <message>
        <source>Pinch so that your mark stays on the moving target.</source>
        <translation>Pincez pour que votre marque reste sur la cible mobile.</translation>
    </message>
    <message>
        <source>Press as hard as is comfortable, and hold it.</source>
        <translation>Appuyez aussi fort que c’est confortable, et tenez.</translation>
    </message>
    <message>
        <source>Press gently and follow the line. Try it out.</source>
        <translation>Appuyez doucement et suivez la ligne. Essayez.</translation>
    </message>
    <message>
        <source>Press in the direction of the arrow, as hard as the ring is large.</source>
        <translation>Appuyez dans la direction de la flèche, aussi fort que l’anneau est grand.</translation>
    </message>
    <message>
        <source>Press slowly harder with the line.</source>
        <translation>Appuyez de plus en plus fort, lentement, avec la ligne.</translation>
    </message>
    <message>
        <source>Press slowly up to the line, hold it, and let go slowly.</source>
        <translation>Appuyez lentement jusqu’à la ligne, tenez, et relâchez lentement.</translation>
    </message>
    <message>
        <source>Press so that your mark stays on the moving target.</source>
        <translation>Appuyez pour que votre marque reste sur la cible mobile.</translation>
    </message>
    <message>
        <source>Press so that your mark stays on the target, also when it gets faster.</source>
        <translation>Appuyez pour que votre marque reste sur la cible, même quand elle accélère.</translation>
    </message>
    <message>
        <source>Press the index finger&apos;s support more firmly, or check its cable.</source>
        <translation>Pressez l’appui de l’index plus fort, ou vérifiez son câble.</translation>
    </message>
    <message>
        <source>Press the index finger&apos;s support straight in and hold.</source>
        <translation>Pressez l’appui de l’index droit vers l’intérieur et tenez.</translation>
    </message>
    <message>
        <source>Press the middle finger&apos;s support more firmly, or check its cable.</source>
        <translation>Pressez l’appui du majeur plus fort, ou vérifiez son câble.</translation>
    </message>
    <message>
        <source>Press the middle finger&apos;s support straight in and hold.</source>
        <translation>Pressez l’appui du majeur droit vers l’intérieur et tenez.</translation>
    </message>
    <message>
        <source>Press the thumb&apos;s support more firmly, or check its cable.</source>
        <translation>Pressez l’appui du pouce plus fort, ou vérifiez son câble.</translation>
    </message>
    <message>
        <source>Press the thumb&apos;s support straight in and hold.</source>
        <translation>Pressez l’appui du pouce droit vers l’intérieur et tenez.</translation>
    </message>
    <message>
        <source>Press up to the line and hold it as still as you can.</source>
        <translation>Appuyez jusqu’à la ligne et tenez aussi stable que possible.</translation>
    </message>
    <message>
        <source>Press when the line goes up, open your hand when it goes down.</source>
        <translation>Appuyez quand la ligne monte, ouvrez la main quand elle descend.</translation>
    </message>
    <message>
        <source>Press with the digit shown. Keep the others still.</source>
        <translation>Appuyez avec le doigt indiqué. Gardez les autres immobiles.</translation>
    </message>
    <message>
        <source>Press with the index finger so that your mark stays on the target.</source>
        <translation>Appuyez avec l’index pour que votre marque reste sur la cible.</translation>
    </message>
    <message>
        <source>Press with the target. You do not see your own force.</source>
        <translation>Appuyez avec la cible. Vous ne voyez pas votre propre force.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (index): muscle tone or a tight strap.</source>
        <translation>Appuie malgré le relâchement (index)&#xa0;: tonus musculaire ou sangle serrée.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (index, middle): muscle tone or a tight strap.</source>
        <translation>Appuie malgré le relâchement (index, majeur)&#xa0;: tonus musculaire ou sangle serrée.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (middle): muscle tone or a tight strap.</source>
        <translation>Appuie malgré le relâchement (majeur)&#xa0;: tonus musculaire ou sangle serrée.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb): muscle tone or a tight strap.</source>
        <translation>Appuie malgré le relâchement (pouce)&#xa0;: tonus musculaire ou sangle serrée.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb, index): muscle tone or a tight strap.</source>
        <translation>Appuie malgré le relâchement (pouce, index)&#xa0;: tonus musculaire ou sangle serrée.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb, index, middle): muscle tone or a tight strap.</source>
        <translation>Appuie malgré le relâchement (pouce, index, majeur)&#xa0;: tonus musculaire ou sangle serrée.</translation>
    </message>
    <message>
        <source>Pressing though relaxed (thumb, middle): muscle tone or a tight strap.</source>
        <translation>Appuie malgré le relâchement (pouce, majeur)&#xa0;: tonus musculaire ou sangle serrée.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (index): look at the strap and the position of the hand.</source>
        <translation>Tire malgré le relâchement (index)&#xa0;: vérifiez la sangle et la position de la main.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (index, middle): look at the strap and the position of the hand.</source>
        <translation>Tire malgré le relâchement (index, majeur)&#xa0;: vérifiez la sangle et la position de la main.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (middle): look at the strap and the position of the hand.</source>
        <translation>Tire malgré le relâchement (majeur)&#xa0;: vérifiez la sangle et la position de la main.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb): look at the strap and the position of the hand.</source>
        <translation>Tire malgré le relâchement (pouce)&#xa0;: vérifiez la sangle et la position de la main.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb, index): look at the strap and the position of the hand.</source>
        <translation>Tire malgré le relâchement (pouce, index)&#xa0;: vérifiez la sangle et la position de la main.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb, index, middle): look at the strap and the position of the hand.</source>
        <translation>Tire malgré le relâchement (pouce, index, majeur)&#xa0;: vérifiez la sangle et la position de la main.</translation>
    </message>
    <message>
        <source>Pulling though relaxed (thumb, middle): look at the strap and the position of the hand.</source>
        <translation>Tire malgré le relâchement (pouce, majeur)&#xa0;: vérifiez la sangle et la position de la main.</translation>
    </message>
    <message>
        <source>Push of the arm</source>
        <translation>Poussée du bras</translation>
    </message>
    <message>
        <source>Push the index finger&apos;s support toward the wrist and hold.</source>
        <translation>Poussez l’appui de l’index vers le poignet et tenez.</translation>
    </message>
    <message>
        <source>Push the index finger&apos;s support upward and hold.</source>
        <translation>Poussez l’appui de l’index vers le haut et tenez.</translation>
    </message>
    <message>
        <source>Push the middle finger&apos;s support toward the wrist and hold.</source>
        <translation>Poussez l’appui du majeur vers le poignet et tenez.</translation>
    </message>
    <message>
        <source>Push the middle finger&apos;s support upward and hold.</source>
        <translation>Poussez l’appui du majeur vers le haut et tenez.</translation>
    </message>
    <message>
        <source>Push the thumb&apos;s support toward the wrist and hold.</source>
        <translation>Poussez l’appui du pouce vers le poignet et tenez.</translation>
    </message>
    <message>
        <source>Push the thumb&apos;s support upward and hold.</source>
        <translation>Poussez l’appui du pouce vers le haut et tenez.</translation>
    </message>
    <message>
        <source>Put the reference weight on the index finger&apos;s support and wait.</source>
        <translation>Posez le poids de référence sur l’appui de l’index et attendez.</translation>
    </message>
    <message>
        <source>Put the reference weight on the middle finger&apos;s support and wait.</source>
        <translation>Posez le poids de référence sur l’appui du majeur et attendez.</translation>
    </message>
    <message>
        <source>Put the reference weight on the thumb&apos;s support and wait.</source>
        <translation>Posez le poids de référence sur l’appui du pouce et attendez.</translation>
    </message>
    <message>
        <source>Reaction time</source>
        <translation>Temps de réaction</translation>
    </message>
    <message>
        <source>Reaction time without the device&apos;s delay</source>
        <translation>Temps de réaction sans le retard de l’appareil</translation>
    </message>
    <message>
        <source>Reaction time, misses at the limit</source>
        <translation>Temps de réaction, échecs à la limite</translation>
    </message>
    <message>
        <source>Recorded handling</source>
        <translation>Manipulation enregistrée</translation>
    </message>
    <message>
        <source>Release time</source>
        <translation>Temps de relâchement</translation>
    </message>
    <message>
        <source>Release time without the device&apos;s delay</source>
        <translation>Temps de relâchement sans le retard de l’appareil</translation>
    </message>
    <message>
        <source>Release time, misses at the limit</source>
        <translation>Temps de relâchement, échecs à la limite</translation>
    </message>
    <message>
        <source>Releases completed</source>
        <translation>Relâchements complets</translation>
    </message>
    <message>
        <source>Resting force</source>
        <translation>Force de repos</translation>
    </message>
    <message>
        <source>Resting grip</source>
        <translation>Prise au repos</translation>
    </message>
    <message>
        <source>Rhythm of the force</source>
        <translation>Rythme de la force</translation>
    </message>
    <message>
        <source>Rhythm of the grip</source>
        <translation>Rythme de la prise</translation>
    </message>
    <message>
        <source>Rise of force in the first 0.2 s</source>
        <translation>Montée de la force dans les 0,2 premières s</translation>
    </message>
    <message>
        <source>Rise of grip in the first 0.2 s</source>
        <translation>Montée de la prise dans les 0,2 premières s</translation>
    </message>
    <message>
        <source>Rise time, 10 to 90 %</source>
        <translation>Temps de montée, 10 à 90 %</translation>
    </message>
    <message>
        <source>Safety margin (virtual)</source>
        <translation>Marge de sécurité (virtuelle)</translation>
    </message>
    <message>
        <source>Sample entropy</source>
        <translation>Entropie d’échantillon</translation>
    </message>
    <message>
        <source>Samples are missing: check the cables of the device, then set the zero again.</source>
        <translation>Des échantillons manquent&#xa0;: vérifiez les câbles de l’appareil, puis refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Temps de stabilisation</translation>
    </message>
    <message>
        <source>Settling time, misses at the limit</source>
        <translation>Temps de stabilisation, échecs à la limite</translation>
    </message>
    <message>
        <source>Share of fast tremor, 8 to 12 Hz</source>
        <translation>Part de tremblement rapide, 8 à 12 Hz</translation>
    </message>
    <message>
        <source>Share of slow correction, 0.5 to 0.8 Hz</source>
        <translation>Part de correction lente, 0,5 à 0,8 Hz</translation>
    </message>
    <message>
        <source>Share of the force</source>
        <translation>Part de la force</translation>
    </message>
    <message>
        <source>Share of the grip</source>
        <translation>Part de la prise</translation>
    </message>
    <message>
        <source>Share of tremor, 2 to 8 Hz</source>
        <translation>Part de tremblement, 2 à 8 Hz</translation>
    </message>
    <message>
        <source>Share of very slow wander, 0.1 to 0.3 Hz</source>
        <translation>Part de dérive très lente, 0,1 à 0,3 Hz</translation>
    </message>
    <message>
        <source>Short demonstration</source>
        <translation>Courte démonstration</translation>
    </message>
    <message>
        <source>Sideways together</source>
        <translation>De côté ensemble</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Glissement</translation>
    </message>
    <message>
        <source>Smoothness (SPARC)</source>
        <translation>Fluidité (SPARC)</translation>
    </message>
    <message>
        <source>Smoothness (log dimensionless jerk)</source>
        <translation>Fluidité (log du jerk adimensionnel)</translation>
    </message>
    <message>
        <source>Spread of the force from memory</source>
        <translation>Dispersion de la force de mémoire</translation>
    </message>
    <message>
        <source>Spread of the grip from memory</source>
        <translation>Dispersion de la prise de mémoire</translation>
    </message>
    <message>
        <source>Spread of the held force</source>
        <translation>Dispersion de la force maintenue</translation>
    </message>
    <message>
        <source>Spread of the held grip</source>
        <translation>Dispersion de la prise maintenue</translation>
    </message>
    <message>
        <source>Steadiness</source>
        <translation>Stabilité</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Échelons</translation>
    </message>
    <message>
        <source>Steps that reached 63 %</source>
        <translation>Échelons ayant atteint 63 %</translation>
    </message>
    <message>
        <source>Steps that settled</source>
        <translation>Échelons stabilisés</translation>
    </message>
    <message>
        <source>Stopped after a device fault.</source>
        <translation>Arrêté après un défaut de l’appareil.</translation>
    </message>
    <message>
        <source>Stopped by the therapist.</source>
        <translation>Arrêté par le thérapeute.</translation>
    </message>
    <message>
        <source>Synergy of the fingers</source>
        <translation>Synergie des doigts</translation>
    </message>
    <message>
        <source>Synergy of the fingers (z)</source>
        <translation>Synergie des doigts (z)</translation>
    </message>
    <message>
        <source>Take the hand out, let nothing touch the device, and set the zero again.</source>
        <translation>Retirez la main, ne laissez rien toucher l’appareil, et refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>Targets reached</source>
        <translation>Cibles atteintes</translation>
    </message>
    <message>
        <source>The block springs back. Push it to its outline and hold it still there.</source>
        <translation>Le bloc revient. Poussez-le à son contour et tenez-le là immobile.</translation>
    </message>
    <message>
        <source>The bus adapter or this computer loses frames: close other programs.</source>
        <translation>L’adaptateur de bus ou cet ordinateur perd des trames&#xa0;: fermez les autres programmes.</translation>
    </message>
    <message>
        <source>The bus adapter was unplugged: plug it in again.</source>
        <translation>L’adaptateur de bus a été débranché&#xa0;: rebranchez-le.</translation>
    </message>
    <message>
        <source>The bus counts many errors: check cable and termination.</source>
        <translation>Le bus compte beaucoup d’erreurs&#xa0;: vérifiez câble et terminaison.</translation>
    </message>
    <message>
        <source>The bus interface is down: switch it on.</source>
        <translation>L’interface de bus est désactivée&#xa0;: activez-la.</translation>
    </message>
    <message>
        <source>The bus is switched off after errors: check cable and termination.</source>
        <translation>Le bus est coupé après des erreurs&#xa0;: vérifiez câble et terminaison.</translation>
    </message>
    <message>
        <source>The device works.</source>
        <translation>L’appareil fonctionne.</translation>
    </message>
    <message>
        <source>The hand was not still: repeat it if the patient can relax more.</source>
        <translation>La main bougeait&#xa0;: répétez si le patient peut se détendre davantage.</translation>
    </message>
    <message>
        <source>The harder you push, the faster the block goes. Bring it to its outline, level, and stop there.</source>
        <translation>Plus vous poussez fort, plus le bloc va vite. Amenez-le bien droit à son contour et arrêtez-vous là.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor is not the one that belongs here: do not measure with it.</source>
        <translation>Le capteur de l’index n’est pas le bon&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor is overloaded: take the hand out.</source>
        <translation>Le capteur de l’index est surchargé&#xa0;: retirez la main.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor is silent: check its cable and power.</source>
        <translation>Le capteur de l’index ne répond pas&#xa0;: vérifiez son câble et son alimentation.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor loses samples on the way: check the bus wiring.</source>
        <translation>Le capteur de l’index perd des échantillons en route&#xa0;: vérifiez le câblage du bus.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Le capteur de l’index répète une valeur&#xa0;: éteignez-le, rallumez-le, puis refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor reports that it is broken: do not measure with it.</source>
        <translation>Le capteur de l’index signale qu’il est en panne&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>The index finger&apos;s sensor started anew: take the hand out and zero again.</source>
        <translation>Le capteur de l’index a redémarré&#xa0;: retirez la main et refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>The index sensor differs from the last empty zero (%1 N, limit %2 N).</source>
        <translation>Le capteur de l’index diffère du dernier zéro à vide (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The index sensor drifts (%1 N/s, limit %2 N/s).</source>
        <translation>Le capteur de l’index dérive (%1 N/s, limite %2 N/s).</translation>
    </message>
    <message>
        <source>The index sensor is loaded (%1 N, limit %2 N).</source>
        <translation>Le capteur de l’index est chargé (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The index sensor is not quiet (%1 N, limit %2 N).</source>
        <translation>Le capteur de l’index n’est pas calme (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The index sensor is not quiet (%1 Nm, limit %2 Nm).</source>
        <translation>Le capteur de l’index n’est pas calme (%1 Nm, limite %2 Nm).</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor is not the one that belongs here: do not measure with it.</source>
        <translation>Le capteur du majeur n’est pas le bon&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor is overloaded: take the hand out.</source>
        <translation>Le capteur du majeur est surchargé&#xa0;: retirez la main.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor is silent: check its cable and power.</source>
        <translation>Le capteur du majeur ne répond pas&#xa0;: vérifiez son câble et son alimentation.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor loses samples on the way: check the bus wiring.</source>
        <translation>Le capteur du majeur perd des échantillons en route&#xa0;: vérifiez le câblage du bus.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Le capteur du majeur répète une valeur&#xa0;: éteignez-le, rallumez-le, puis refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor reports that it is broken: do not measure with it.</source>
        <translation>Le capteur du majeur signale qu’il est en panne&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>The middle finger&apos;s sensor started anew: take the hand out and zero again.</source>
        <translation>Le capteur du majeur a redémarré&#xa0;: retirez la main et refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>The middle sensor differs from the last empty zero (%1 N, limit %2 N).</source>
        <translation>Le capteur du majeur diffère du dernier zéro à vide (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The middle sensor drifts (%1 N/s, limit %2 N/s).</source>
        <translation>Le capteur du majeur dérive (%1 N/s, limite %2 N/s).</translation>
    </message>
    <message>
        <source>The middle sensor is loaded (%1 N, limit %2 N).</source>
        <translation>Le capteur du majeur est chargé (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The middle sensor is not quiet (%1 N, limit %2 N).</source>
        <translation>Le capteur du majeur n’est pas calme (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The middle sensor is not quiet (%1 Nm, limit %2 Nm).</source>
        <translation>Le capteur du majeur n’est pas calme (%1 Nm, limite %2 Nm).</translation>
    </message>
    <message>
        <source>The outline jumps to another place. Bring the block there as fast as you can.</source>
        <translation>Le contour saute ailleurs. Amenez-y le bloc aussi vite que possible.</translation>
    </message>
    <message>
        <source>The outline moves to the left and to the right. Keep the block on it.</source>
        <translation>Le contour va à gauche et à droite. Gardez le bloc dessus.</translation>
    </message>
    <message>
        <source>The outline wanders and turns. Keep the block on it.</source>
        <translation>Le contour se déplace et tourne. Gardez le bloc dessus.</translation>
    </message>
    <message>
        <source>The recording ended.</source>
        <translation>L’enregistrement s’est terminé.</translation>
    </message>
    <message>
        <source>The same of that digit&apos;s maximum</source>
        <translation>La même, du maximum de ce doigt</translation>
    </message>
    <message>
        <source>The sensor under the index finger&apos;s support shows %1 N for a weight of %2 N.</source>
        <translation>Le capteur sous l’appui de l’index indique %1 N pour un poids de %2 N.</translation>
    </message>
    <message>
        <source>The sensor under the index finger&apos;s support shows another direction (%1 N up, %2 N toward the wrist, %3 N in): it is turned.</source>
        <translation>Le capteur sous l’appui de l’index indique une autre direction (%1 N vers le haut, %2 N vers le poignet, %3 N vers l’intérieur)&#xa0;: il est tourné.</translation>
    </message>
    <message>
        <source>The sensor under the index finger&apos;s support shows the opposite direction.</source>
        <translation>Le capteur sous l’appui de l’index indique la direction opposée.</translation>
    </message>
    <message>
        <source>The sensor under the middle finger&apos;s support shows %1 N for a weight of %2 N.</source>
        <translation>Le capteur sous l’appui du majeur indique %1 N pour un poids de %2 N.</translation>
    </message>
    <message>
        <source>The sensor under the middle finger&apos;s support shows another direction (%1 N up, %2 N toward the wrist, %3 N in): it is turned.</source>
        <translation>Le capteur sous l’appui du majeur indique une autre direction (%1 N vers le haut, %2 N vers le poignet, %3 N vers l’intérieur)&#xa0;: il est tourné.</translation>
    </message>
    <message>
        <source>The sensor under the middle finger&apos;s support shows the opposite direction.</source>
        <translation>Le capteur sous l’appui du majeur indique la direction opposée.</translation>
    </message>
    <message>
        <source>The sensor under the thumb&apos;s support shows %1 N for a weight of %2 N.</source>
        <translation>Le capteur sous l’appui du pouce indique %1 N pour un poids de %2 N.</translation>
    </message>
    <message>
        <source>The sensor under the thumb&apos;s support shows another direction (%1 N up, %2 N toward the wrist, %3 N in): it is turned.</source>
        <translation>Le capteur sous l’appui du pouce indique une autre direction (%1 N vers le haut, %2 N vers le poignet, %3 N vers l’intérieur)&#xa0;: il est tourné.</translation>
    </message>
    <message>
        <source>The sensor under the thumb&apos;s support shows the opposite direction.</source>
        <translation>Le capteur sous l’appui du pouce indique la direction opposée.</translation>
    </message>
    <message>
        <source>The session was closed.</source>
        <translation>La séance a été close.</translation>
    </message>
    <message>
        <source>The thumb sensor differs from the last empty zero (%1 N, limit %2 N).</source>
        <translation>Le capteur du pouce diffère du dernier zéro à vide (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The thumb sensor drifts (%1 N/s, limit %2 N/s).</source>
        <translation>Le capteur du pouce dérive (%1 N/s, limite %2 N/s).</translation>
    </message>
    <message>
        <source>The thumb sensor is loaded (%1 N, limit %2 N).</source>
        <translation>Le capteur du pouce est chargé (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The thumb sensor is not quiet (%1 N, limit %2 N).</source>
        <translation>Le capteur du pouce n’est pas calme (%1 N, limite %2 N).</translation>
    </message>
    <message>
        <source>The thumb sensor is not quiet (%1 Nm, limit %2 Nm).</source>
        <translation>Le capteur du pouce n’est pas calme (%1 Nm, limite %2 Nm).</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor is not the one that belongs here: do not measure with it.</source>
        <translation>Le capteur du pouce n’est pas le bon&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor is overloaded: take the hand out.</source>
        <translation>Le capteur du pouce est surchargé&#xa0;: retirez la main.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor is silent: check its cable and power.</source>
        <translation>Le capteur du pouce ne répond pas&#xa0;: vérifiez son câble et son alimentation.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor loses samples on the way: check the bus wiring.</source>
        <translation>Le capteur du pouce perd des échantillons en route&#xa0;: vérifiez le câblage du bus.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor repeats one value: switch it off and on, then zero again.</source>
        <translation>Le capteur du pouce répète une valeur&#xa0;: éteignez-le, rallumez-le, puis refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor reports that it is broken: do not measure with it.</source>
        <translation>Le capteur du pouce signale qu’il est en panne&#xa0;: ne mesurez pas avec.</translation>
    </message>
    <message>
        <source>The thumb&apos;s sensor started anew: take the hand out and zero again.</source>
        <translation>Le capteur du pouce a redémarré&#xa0;: retirez la main et refaites la mise à zéro.</translation>
    </message>
    <message>
        <source>The zero has drifted by %1 N since the one before: the trials between are marked.</source>
        <translation>Le zéro a dérivé de %1 N depuis le précédent&#xa0;: les essais entre les deux sont marqués.</translation>
    </message>
    <message>
        <source>Three-digit individuation</source>
        <translation>Individuation des trois doigts</translation>
    </message>
    <message>
        <source>Throughput</source>
        <translation>Débit</translation>
    </message>
    <message>
        <source>Thumb against the fingers</source>
        <translation>Pouce contre les doigts</translation>
    </message>
    <message>
        <source>Tilt in transport</source>
        <translation>Inclinaison pendant le transport</translation>
    </message>
    <message>
        <source>Time in contact</source>
        <translation>Temps de contact</translation>
    </message>
    <message>
        <source>Time in the corridor</source>
        <translation>Temps dans le couloir</translation>
    </message>
    <message>
        <source>Time on target</source>
        <translation>Temps sur la cible</translation>
    </message>
    <message>
        <source>Time to 63 % of the step</source>
        <translation>Temps jusqu’à 63 % de l’échelon</translation>
    </message>
    <message>
        <source>Time to 63 % of the step, misses at the limit</source>
        <translation>Temps jusqu’à 63 % de l’échelon, échecs à la limite</translation>
    </message>
    <message>
        <source>Time to reach</source>
        <translation>Temps d’atteinte</translation>
    </message>
    <message>
        <source>Time until letting go begins</source>
        <translation>Temps avant le début du relâchement</translation>
    </message>
    <message>
        <source>Time until letting go begins, misses at the limit</source>
        <translation>Temps avant le début du relâchement, échecs à la limite</translation>
    </message>
    <message>
        <source>Time until letting go begins, without the device&apos;s delay</source>
        <translation>Temps avant le début du relâchement, sans le retard de l’appareil</translation>
    </message>
    <message>
        <source>Time with a push of more than 20 %</source>
        <translation>Temps avec une poussée de plus de 20 %</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Va-et-vient</translation>
    </message>
    <message>
        <source>Tracking error (RMS)</source>
        <translation>Erreur de poursuite (RMS)</translation>
    </message>
    <message>
        <source>Tracking error (mean)</source>
        <translation>Erreur de poursuite (moyenne)</translation>
    </message>
    <message>
        <source>Tracking error, relative</source>
        <translation>Erreur de poursuite, relative</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Entraînement</translation>
    </message>
    <message>
        <source>Turn the knob</source>
        <translation>Tourner le bouton</translation>
    </message>
    <message>
        <source>Turn the knob to the mark and hold it still there.</source>
        <translation>Tournez le bouton jusqu’à la marque et tenez-le là immobile.</translation>
    </message>
    <message>
        <source>Turn the knob to the mark. Stop turning when you are there and hold it still.</source>
        <translation>Tournez le bouton jusqu’à la marque. Arrêtez-vous là et tenez-le immobile.</translation>
    </message>
    <message>
        <source>Turn the knob, rate control</source>
        <translation>Tourner le bouton, commande en vitesse</translation>
    </message>
    <message>
        <source>Two targets</source>
        <translation>Deux cibles</translation>
    </message>
    <message>
        <source>Two targets, long way</source>
        <translation>Deux cibles, long trajet</translation>
    </message>
    <message>
        <source>Two targets, mirrored</source>
        <translation>Deux cibles, en miroir</translation>
    </message>
    <message>
        <source>Two targets, rate control</source>
        <translation>Deux cibles, commande en vitesse</translation>
    </message>
    <message>
        <source>Two targets, training</source>
        <translation>Deux cibles, entraînement</translation>
    </message>
    <message>
        <source>Two targets, weak hand</source>
        <translation>Deux cibles, main faible</translation>
    </message>
    <message>
        <source>Unasked force per force asked</source>
        <translation>Force non demandée par force demandée</translation>
    </message>
    <message>
        <source>Unasked grip per force asked</source>
        <translation>Prise non demandée par force demandée</translation>
    </message>
    <message>
        <source>Unsteadiness (CV)</source>
        <translation>Instabilité (CV)</translation>
    </message>
    <message>
        <source>Unwanted flexion</source>
        <translation>Flexion involontaire</translation>
    </message>
    <message>
        <source>Useful share of the force</source>
        <translation>Part utile de la force</translation>
    </message>
    <message>
        <source>Useful share of the grip</source>
        <translation>Part utile de la prise</translation>
    </message>
    <message>
        <source>Variance that changes the sum</source>
        <translation>Variance qui change la somme</translation>
    </message>
    <message>
        <source>Variance that leaves the sum alone</source>
        <translation>Variance qui conserve la somme</translation>
    </message>
    <message>
        <source>Variation of the grip</source>
        <translation>Variation de la prise</translation>
    </message>
    <message>
        <source>When the screen says so: lift the index finger against the strap, build up, pull, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: levez l’index contre la sangle, montez, tirez, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says so: lift the middle finger against the strap, build up, pull, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: levez le majeur contre la sangle, montez, tirez, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says so: lift the thumb against the strap, build up, pull, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: levez le pouce contre la sangle, montez, tirez, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says so: open your hand against the straps, build up, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: ouvrez la main contre les sangles, montez, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says so: pinch with thumb and index finger, build up, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: pincez avec le pouce et l’index, montez, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says so: press with the index finger, build up, press hard, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: appuyez avec l’index, montez, appuyez fort, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says so: press with the middle finger, build up, press hard, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: appuyez avec le majeur, montez, appuyez fort, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says so: press with the thumb, build up, press hard, breathe out, stop.</source>
        <translation>Quand l’écran le dit&#xa0;: appuyez avec le pouce, montez, appuyez fort, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the screen says squeeze: build up over one second, squeeze, breathe out, stop.</source>
        <translation>Quand l’écran dit «&#xa0;Serrez&#xa0;»&#xa0;: montez en une seconde, serrez, expirez, arrêtez.</translation>
    </message>
    <message>
        <source>When the target jumps, follow it at once and stay on it.</source>
        <translation>Quand la cible saute, suivez-la aussitôt et restez dessus.</translation>
    </message>
    <message>
        <source>a group of signals has no columns</source>
        <translation>un groupe de signaux n’a pas de colonnes</translation>
    </message>
    <message>
        <source>a signal does not vary</source>
        <translation>un signal ne varie pas</translation>
    </message>
    <message>
        <source>a trial or a zero is still running</source>
        <translation>un essai ou une mise à zéro est en cours</translation>
    </message>
    <message>
        <source>already there at the cue</source>
        <translation>déjà là au signal</translation>
    </message>
    <message>
        <source>checking trial %1</source>
        <translation>vérification de l’essai %1</translation>
    </message>
    <message>
        <source>do not use it: take a backup that you trust</source>
        <translation>ne l’utilisez pas : prenez une sauvegarde digne de confiance</translation>
    </message>
    <message>
        <source>end it and go on with another one</source>
        <translation>terminez-le et continuez avec un autre</translation>
    </message>
    <message>
        <source>fewer than %1 trials</source>
        <translation>moins de %1 essais</translation>
    </message>
    <message>
        <source>fewer than four samples</source>
        <translation>moins de quatre échantillons</translation>
    </message>
    <message>
        <source>fewer than ten trials</source>
        <translation>moins de dix essais</translation>
    </message>
    <message>
        <source>fewer than three holds with force</source>
        <translation>moins de trois maintiens avec force</translation>
    </message>
    <message>
        <source>fewer than three samples</source>
        <translation>moins de trois échantillons</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>moins de deux échantillons</translation>
    </message>
    <message>
        <source>forces, contacts or utilisation of the fingers are missing</source>
        <translation>les forces, contacts ou utilisations des doigts manquent</translation>
    </message>
    <message>
        <source>give at most %1</source>
        <translation>donnez-en au plus %1</translation>
    </message>
    <message>
        <source>grip or load does not vary</source>
        <translation>la prise ou la charge ne varie pas</translation>
    </message>
    <message>
        <source>higher is better</source>
        <translation>plus haut est mieux</translation>
    </message>
    <message>
        <source>holds views or computed columns, which isograsp never makes</source>
        <translation>contient des vues ou des colonnes calculées, qu’isograsp ne crée jamais</translation>
    </message>
    <message>
        <source>is being written by another program now</source>
        <translation>est en cours d’écriture par un autre programme</translation>
    </message>
    <message>
        <source>is not a file but a pipe, a socket or a device</source>
        <translation>n’est pas un fichier mais un tube, une socket ou un périphérique</translation>
    </message>
    <message>
        <source>is written, but its folder cannot be synchronised</source>
        <translation>est écrit, mais son dossier ne peut pas être synchronisé</translation>
    </message>
    <message>
        <source>it says that it has %1 samples of %2 columns, more than any trial</source>
        <translation>il annonce %1 échantillons de %2 colonnes, plus que tout essai</translation>
    </message>
    <message>
        <source>k of n</source>
        <translation>k sur n</translation>
    </message>
    <message>
        <source>less than one whole cycle</source>
        <translation>moins d’un cycle entier</translation>
    </message>
    <message>
        <source>less than one whole cycle of the smallest frequency or difference</source>
        <translation>moins d’un cycle entier de la plus petite fréquence ou différence</translation>
    </message>
    <message>
        <source>let go before the cue</source>
        <translation>relâché avant le signal</translation>
    </message>
    <message>
        <source>longer than any trial</source>
        <translation>plus long que tout essai</translation>
    </message>
    <message>
        <source>longer than the limit</source>
        <translation>plus long que la limite</translation>
    </message>
    <message>
        <source>lower is better</source>
        <translation>plus bas est mieux</translation>
    </message>
    <message>
        <source>nearer to zero is better</source>
        <translation>plus près de zéro est mieux</translation>
    </message>
    <message>
        <source>no finger touched with friction</source>
        <translation>aucun doigt n’a touché avec friction</translation>
    </message>
    <message>
        <source>no force held before the cue</source>
        <translation>aucune force maintenue avant le signal</translation>
    </message>
    <message>
        <source>no force in this direction</source>
        <translation>aucune force dans cette direction</translation>
    </message>
    <message>
        <source>no level before the cue</source>
        <translation>aucun niveau avant le signal</translation>
    </message>
    <message>
        <source>no more than %1 s of force</source>
        <translation>pas plus de %1 s de force</translation>
    </message>
    <message>
        <source>no overshoot</source>
        <translation>aucun dépassement</translation>
    </message>
    <message>
        <source>no pauses</source>
        <translation>aucune pause</translation>
    </message>
    <message>
        <source>no reaction to the cue</source>
        <translation>aucune réaction au signal</translation>
    </message>
    <message>
        <source>no repetitions</source>
        <translation>aucune répétition</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>aucun échantillon</translation>
    </message>
    <message>
        <source>no samples after the cue</source>
        <translation>aucun échantillon après le signal</translation>
    </message>
    <message>
        <source>no templates match</source>
        <translation>aucun motif ne concorde</translation>
    </message>
    <message>
        <source>no uninterrupted window of valid samples is long enough</source>
        <translation>aucune fenêtre continue d’échantillons valides n’est assez longue</translation>
    </message>
    <message>
        <source>no values</source>
        <translation>aucune valeur</translation>
    </message>
    <message>
        <source>nobody has confirmed that the device is empty</source>
        <translation>personne n’a confirmé que l’appareil est vide</translation>
    </message>
    <message>
        <source>not recorded %1 s after the cue</source>
        <translation>non enregistré %1 s après le signal</translation>
    </message>
    <message>
        <source>not released</source>
        <translation>non relâché</translation>
    </message>
    <message>
        <source>not settled for %1 s</source>
        <translation>non stabilisé pendant %1 s</translation>
    </message>
    <message>
        <source>nothing is answered at this frequency</source>
        <translation>aucune réponse à cette fréquence</translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation>rien n’a bougé</translation>
    </message>
    <message>
        <source>nothing was placed</source>
        <translation>rien n’a été posé</translation>
    </message>
    <message>
        <source>nothing was tried</source>
        <translation>rien n’a été tenté</translation>
    </message>
    <message>
        <source>one repetition only</source>
        <translation>une seule répétition</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>page %1 sur %2</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <translation>partie %1 sur %2</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>run the comfortable-force task of it first</source>
        <translation>mesurez d’abord sa force confortable</translation>
    </message>
    <message>
        <source>run the resting-force task and a maximum task of it first</source>
        <translation>mesurez d’abord la force de repos et son maximum</translation>
    </message>
    <message>
        <source>session %1 of %2</source>
        <translation>séance %1 sur %2</translation>
    </message>
    <message>
        <source>shorter than one window of %1 s</source>
        <translation>plus court qu’une fenêtre de %1 s</translation>
    </message>
    <message>
        <source>shorter than the lags that are tried</source>
        <translation>plus court que les décalages essayés</translation>
    </message>
    <message>
        <source>take the hand out, let nothing touch the supports, and confirm that</source>
        <translation>retirez la main, ne laissez rien toucher les appuis, et confirmez-le</translation>
    </message>
    <message>
        <source>target or actual does not vary</source>
        <translation>la cible ou la valeur réelle ne varie pas</translation>
    </message>
    <message>
        <source>task %1 of %2</source>
        <translation>tâche %1 sur %2</translation>
    </message>
    <message>
        <source>the band has no line of the spectrum</source>
        <translation>la bande ne contient aucune raie du spectre</translation>
    </message>
    <message>
        <source>the correlation has no peak within %1 s</source>
        <translation>la corrélation n’a pas de pic en %1 s</translation>
    </message>
    <message>
        <source>the correlation stays below %1</source>
        <translation>la corrélation reste sous %1</translation>
    </message>
    <message>
        <source>the delay of the device is not known</source>
        <translation>le retard de l’appareil n’est pas connu</translation>
    </message>
    <message>
        <source>the delay was not measured and is contained in the raw value</source>
        <translation>le retard n’a pas été mesuré et reste dans la valeur brute</translation>
    </message>
    <message>
        <source>the digits did not press</source>
        <translation>les doigts n’ont pas appuyé</translation>
    </message>
    <message>
        <source>the distance is negative</source>
        <translation>la distance est négative</translation>
    </message>
    <message>
        <source>the end points do not vary</source>
        <translation>les points d’arrivée ne varient pas</translation>
    </message>
    <message>
        <source>the fingers did not press</source>
        <translation>les doigts n’ont pas appuyé</translation>
    </message>
    <message>
        <source>the first %1 s have no force</source>
        <translation>les %1 premières s n’ont pas de force</translation>
    </message>
    <message>
        <source>the fixed load begins with the second assessment</source>
        <translation>la charge fixe commence au deuxième bilan</translation>
    </message>
    <message>
        <source>the force before the cue is not known</source>
        <translation>la force avant le signal n’est pas connue</translation>
    </message>
    <message>
        <source>the force ends where it began</source>
        <translation>la force finit où elle a commencé</translation>
    </message>
    <message>
        <source>the force never falls</source>
        <translation>la force ne baisse jamais</translation>
    </message>
    <message>
        <source>the force never rises</source>
        <translation>la force ne monte jamais</translation>
    </message>
    <message>
        <source>the force never rose above rest</source>
        <translation>la force n’a jamais dépassé le repos</translation>
    </message>
    <message>
        <source>the force stayed above %1 %</source>
        <translation>la force est restée au-dessus de %1 %</translation>
    </message>
    <message>
        <source>the forces do not vary</source>
        <translation>les forces ne varient pas</translation>
    </message>
    <message>
        <source>the hand was strapped less than a minute ago and still settles</source>
        <translation>la main est sanglée depuis moins d’une minute et se stabilise encore</translation>
    </message>
    <message>
        <source>the header names %1 columns</source>
        <translation>l’en-tête nomme %1 colonnes</translation>
    </message>
    <message>
        <source>the last attempts ended before the limit</source>
        <translation>les dernières tentatives ont fini avant la limite</translation>
    </message>
    <message>
        <source>the level was not reached</source>
        <translation>le niveau n’a pas été atteint</translation>
    </message>
    <message>
        <source>the maximum of the digit is not known</source>
        <translation>le maximum du doigt n’est pas connu</translation>
    </message>
    <message>
        <source>the mean is not positive</source>
        <translation>la moyenne n’est pas positive</translation>
    </message>
    <message>
        <source>the mean is zero</source>
        <translation>la moyenne est nulle</translation>
    </message>
    <message>
        <source>the noise of the empty device was not measured</source>
        <translation>le bruit de l’appareil vide n’a pas été mesuré</translation>
    </message>
    <message>
        <source>the other digits did not move</source>
        <translation>les autres doigts n’ont pas bougé</translation>
    </message>
    <message>
        <source>the record ends within %1 s of the onset</source>
        <translation>l’enregistrement finit moins de %1 s après le début</translation>
    </message>
    <message>
        <source>the resting force was not measured</source>
        <translation>la force de repos n’a pas été mesurée</translation>
    </message>
    <message>
        <source>the result is not finite</source>
        <translation>le résultat n’est pas fini</translation>
    </message>
    <message>
        <source>the sampling rate is too low for a spectrum</source>
        <translation>la cadence est trop basse pour un spectre</translation>
    </message>
    <message>
        <source>the sampling rate is too low for the band</source>
        <translation>la cadence est trop basse pour la bande</translation>
    </message>
    <message>
        <source>the signal does not vary</source>
        <translation>le signal ne varie pas</translation>
    </message>
    <message>
        <source>the spectrum has no peak in the band</source>
        <translation>le spectre n’a pas de pic dans la bande</translation>
    </message>
    <message>
        <source>the spectrum has no range</source>
        <translation>le spectre n’a pas d’étendue</translation>
    </message>
    <message>
        <source>the speed never changes its slope</source>
        <translation>la vitesse ne change jamais de pente</translation>
    </message>
    <message>
        <source>the target has no component at its frequency</source>
        <translation>la cible n’a pas de composante à sa fréquence</translation>
    </message>
    <message>
        <source>the target has no component at this frequency</source>
        <translation>la cible n’a pas de composante à cette fréquence</translation>
    </message>
    <message>
        <source>the target has no width</source>
        <translation>la cible n’a pas de largeur</translation>
    </message>
    <message>
        <source>the target is a share of the baseline maximum of &apos;grip&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part du maximum initial de la prise, et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target is a share of the comfortable force of &apos;grip&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part de la force confortable de la prise, et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;grip&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part de la force maximale de la prise, et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;index&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part de la force maximale de l’index, et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;middle&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part de la force maximale du majeur, et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;pinch&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part de la force maximale de la pince, et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target is a share of the maximum force of &apos;thumb&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part de la force maximale du pouce, et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target is zero throughout</source>
        <translation>la cible est nulle partout</translation>
    </message>
    <message>
        <source>the targets lie at different distances</source>
        <translation>les cibles sont à des distances différentes</translation>
    </message>
    <message>
        <source>the trial ended before it was reached</source>
        <translation>l’essai a fini avant qu’elle soit atteinte</translation>
    </message>
    <message>
        <source>the trial ended before this target</source>
        <translation>l’essai a fini avant cette cible</translation>
    </message>
    <message>
        <source>the trial holds more values than can be read again</source>
        <translation>l’essai contient plus de valeurs qu’on ne peut en relire</translation>
    </message>
    <message>
        <source>the two digits did not touch together</source>
        <translation>les deux doigts n’ont pas touché ensemble</translation>
    </message>
    <message>
        <source>there was no contact</source>
        <translation>il n’y a pas eu de contact</translation>
    </message>
    <message>
        <source>there was no cue</source>
        <translation>il n’y a pas eu de signal</translation>
    </message>
    <message>
        <source>there was no force</source>
        <translation>il n’y a pas eu de force</translation>
    </message>
    <message>
        <source>there was no grip</source>
        <translation>il n’y a pas eu de prise</translation>
    </message>
    <message>
        <source>there was no hold in which the instructed digit pressed</source>
        <translation>le doigt demandé n’a appuyé dans aucun maintien</translation>
    </message>
    <message>
        <source>there was no hold of the instructed digit</source>
        <translation>il n’y a pas eu de maintien du doigt demandé</translation>
    </message>
    <message>
        <source>there was no level transport</source>
        <translation>il n’y a pas eu de transport droit</translation>
    </message>
    <message>
        <source>there was no opening force</source>
        <translation>il n’y a pas eu de force d’ouverture</translation>
    </message>
    <message>
        <source>there was no repetition</source>
        <translation>il n’y a pas eu de répétition</translation>
    </message>
    <message>
        <source>this line is longer than %1</source>
        <translation>cette ligne est plus longue que %1</translation>
    </message>
    <message>
        <source>thumb and fingers did not hold the object together</source>
        <translation>le pouce et les doigts n’ont pas tenu l’objet ensemble</translation>
    </message>
    <message>
        <source>too few samples for a %1 Hz low-pass</source>
        <translation>trop peu d’échantillons pour un passe-bas de %1 Hz</translation>
    </message>
    <message>
        <source>too few samples for a sine</source>
        <translation>trop peu d’échantillons pour un sinus</translation>
    </message>
    <message>
        <source>too few samples for these sines</source>
        <translation>trop peu d’échantillons pour ces sinus</translation>
    </message>
    <message>
        <source>wait another %1 s</source>
        <translation>attendez encore %1 s</translation>
    </message>
    <message>
        <source>wait for its end</source>
        <translation>attendez sa fin</translation>
    </message>
    <message>
        <source>Take everything off the supports and do not touch them.</source>
        <translation>Retirez tout des appuis et ne les touchez pas.</translation>
    </message>
    <message>
        <source>Guided check passed.</source>
        <translation>Vérification guidée réussie.</translation>
    </message>
    <message>
        <source>Rest and maximum</source>
        <translation>Repos et maximum</translation>
    </message>
    <message>
        <source>Follow a force</source>
        <translation>Suivre une force</translation>
    </message>
    <message>
        <source>Hold and let go</source>
        <translation>Tenir et relâcher</translation>
    </message>
    <message>
        <source>Single fingers, directions</source>
        <translation>Doigts seuls, directions</translation>
    </message>
    <message>
        <source>Move an object</source>
        <translation>Déplacer un objet</translation>
    </message>
    <message>
        <source>Simulated sensors, arm_push patient</source>
        <translation>Capteurs simulés, patient&#xa0;: poussée du bras</translation>
    </message>
    <message>
        <source>Simulated sensors, direction_error patient</source>
        <translation>Capteurs simulés, patient&#xa0;: erreur de direction</translation>
    </message>
    <message>
        <source>Simulated sensors, fatiguing patient</source>
        <translation>Capteurs simulés, patient&#xa0;: fatigable</translation>
    </message>
    <message>
        <source>Simulated sensors, healthy patient</source>
        <translation>Capteurs simulés, patient&#xa0;: sain</translation>
    </message>
    <message>
        <source>Simulated sensors, inattention patient</source>
        <translation>Capteurs simulés, patient&#xa0;: inattentif</translation>
    </message>
    <message>
        <source>Simulated sensors, mild patient</source>
        <translation>Capteurs simulés, patient&#xa0;: atteinte légère</translation>
    </message>
    <message>
        <source>Simulated sensors, moderate patient</source>
        <translation>Capteurs simulés, patient&#xa0;: atteinte modérée</translation>
    </message>
    <message>
        <source>Simulated sensors, opening_loss patient</source>
        <translation>Capteurs simulés, patient&#xa0;: perte d’ouverture</translation>
    </message>
    <message>
        <source>Simulated sensors, pain_stop patient</source>
        <translation>Capteurs simulés, patient&#xa0;: arrêt sur douleur</translation>
    </message>
    <message>
        <source>Simulated sensors, paretic patient</source>
        <translation>Capteurs simulés, patient&#xa0;: parétique</translation>
    </message>
    <message>
        <source>Simulated sensors, sensory_loss patient</source>
        <translation>Capteurs simulés, patient&#xa0;: perte sensorielle</translation>
    </message>
    <message>
        <source>Simulated sensors, severe patient</source>
        <translation>Capteurs simulés, patient&#xa0;: atteinte sévère</translation>
    </message>
    <message>
        <source>Simulated sensors, slow_wander patient</source>
        <translation>Capteurs simulés, patient&#xa0;: dérive lente</translation>
    </message>
    <message>
        <source>Simulated sensors, spastic patient</source>
        <translation>Capteurs simulés, patient&#xa0;: spastique</translation>
    </message>
    <message>
        <source>Simulated sensors, submaximal patient</source>
        <translation>Capteurs simulés, patient&#xa0;: sous-maximal</translation>
    </message>
    <message>
        <source>index fx</source>
        <translation>index, force x</translation>
    </message>
    <message>
        <source>index fy</source>
        <translation>index, force y</translation>
    </message>
    <message>
        <source>index fz</source>
        <translation>index, force z</translation>
    </message>
    <message>
        <source>index tx</source>
        <translation>index, moment x</translation>
    </message>
    <message>
        <source>index ty</source>
        <translation>index, moment y</translation>
    </message>
    <message>
        <source>index tz</source>
        <translation>index, moment z</translation>
    </message>
    <message>
        <source>middle fx</source>
        <translation>majeur, force x</translation>
    </message>
    <message>
        <source>middle fy</source>
        <translation>majeur, force y</translation>
    </message>
    <message>
        <source>middle fz</source>
        <translation>majeur, force z</translation>
    </message>
    <message>
        <source>middle tx</source>
        <translation>majeur, moment x</translation>
    </message>
    <message>
        <source>middle ty</source>
        <translation>majeur, moment y</translation>
    </message>
    <message>
        <source>middle tz</source>
        <translation>majeur, moment z</translation>
    </message>
    <message>
        <source>thumb fx</source>
        <translation>pouce, force x</translation>
    </message>
    <message>
        <source>thumb fy</source>
        <translation>pouce, force y</translation>
    </message>
    <message>
        <source>thumb fz</source>
        <translation>pouce, force z</translation>
    </message>
    <message>
        <source>thumb tx</source>
        <translation>pouce, moment x</translation>
    </message>
    <message>
        <source>thumb ty</source>
        <translation>pouce, moment y</translation>
    </message>
    <message>
        <source>thumb tz</source>
        <translation>pouce, moment z</translation>
    </message>
    <message>
        <source>cannot be judged yet</source>
        <translation>pas encore évaluable</translation>
    </message>
    <message>
        <source>improved (confirmed)</source>
        <translation>amélioré (confirmé)</translation>
    </message>
    <message>
        <source>improved (possible)</source>
        <translation>amélioré (possible)</translation>
    </message>
    <message>
        <source>not larger than measurement error</source>
        <translation>pas plus grand que l’erreur de mesure</translation>
    </message>
    <message>
        <source>wait until it is done, or give another name</source>
        <translation>attendez qu’il ait fini ou donnez un autre nom</translation>
    </message>
    <message>
        <source>worsened (confirmed)</source>
        <translation>dégradé (confirmé)</translation>
    </message>
    <message>
        <source>worsened (possible)</source>
        <translation>dégradé (possible)</translation>
    </message>
    <message>
        <source>a day of the baseline has no value</source>
        <translation>un jour du niveau initial n’a pas de valeur</translation>
    </message>
    <message>
        <source>a value is not positive, its error is a share</source>
        <translation>une valeur n’est pas positive, son erreur est une proportion</translation>
    </message>
    <message>
        <source>more of it is neither better nor worse</source>
        <translation>plus n’est ni mieux ni pire</translation>
    </message>
    <message>
        <source>no assessment after the baseline</source>
        <translation>aucun bilan après le niveau initial</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
    <message>
        <source>stable pairs of %1 people instead of %2</source>
        <translation>paires stables de %1 personnes au lieu de %2</translation>
    </message>
    <message>
        <source>stable people show no variation</source>
        <translation>les personnes stables ne montrent aucune variation</translation>
    </message>
    <message>
        <source>the affected side is not known</source>
        <translation>le côté atteint n’est pas connu</translation>
    </message>
    <message>
        <source>the baseline needs two assessment days</source>
        <translation>le niveau initial exige deux jours de bilan</translation>
    </message>
    <message>
        <source>the last assessment has no value</source>
        <translation>le dernier bilan n’a pas de valeur</translation>
    </message>
    <message>
        <source>the level of its trials follows success</source>
        <translation>le niveau de ses essais suit la réussite</translation>
    </message>
    <message>
        <source>%1 minutes of work are done: end the session for today.</source>
        <translation>%1 minutes de travail sont faites : terminez la séance pour aujourd’hui.</translation>
    </message>
    <message>
        <source>The maximum has fallen by %1 % in this session: stop the work of this hand for today.</source>
        <translation>Le maximum a baissé de %1 % pendant cette séance : arrêtez le travail de cette main pour aujourd’hui.</translation>
    </message>
    <message>
        <source>%1 boxes send records, the last is %2</source>
        <translation>%1 boîtiers envoient des mesures, le dernier est %2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1&#xa0;: ne peut pas être écrit</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 ne répond pas</translation>
    </message>
    <message>
        <source>%1 does not have the calibration that the configuration names%2</source>
        <translation>%1 n’a pas l’étalonnage indiqué par la configuration%2</translation>
    </message>
    <message>
        <source>%1 has the serial number %2, but the configuration says %3</source>
        <translation>%1 a le numéro de série %2, mais la configuration indique %3</translation>
    </message>
    <message>
        <source>%1 is locked but has an initial velocity</source>
        <translation>%1 est bloqué mais a une vitesse initiale</translation>
    </message>
    <message>
        <source>%1 is no possible length of the filter</source>
        <translation>%1 n’est pas une longueur possible du filtre</translation>
    </message>
    <message>
        <source>%1 is no score of the %2</source>
        <translation>%1 n’est pas un score de %2</translation>
    </message>
    <message>
        <source>%1 is no year of birth</source>
        <translation>%1 n’est pas une année de naissance</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 est hors limites</translation>
    </message>
    <message>
        <source>%1 not defined: %2.</source>
        <translation>%1 non défini&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1 of %2 is a primary measure</source>
        <translation>%1 de %2 est déjà une mesure principale</translation>
    </message>
    <message>
        <source>%1 of %2 was changed or is damaged</source>
        <translation>%1 de %2&#xa0;: modifié ou endommagé</translation>
    </message>
    <message>
        <source>%1 refused a setting (%2)</source>
        <translation>%1 a refusé un réglage (%2)</translation>
    </message>
    <message>
        <source>%1 sensors do not speak over %2://</source>
        <translation>les capteurs %1 ne communiquent pas par %2://</translation>
    </message>
    <message>
        <source>%1 taps cannot make this cut-off at this rate</source>
        <translation>%1 coefficients ne permettent pas cette fréquence de coupure à cette cadence</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 values</source>
        <translation>%1 valeurs</translation>
    </message>
    <message>
        <source>%1, and the bit rate of the interface: boards leave the factory at 250 kbit/s</source>
        <translation>%1, et le débit de l’interface&#xa0;: les cartes sortent d’usine à 250 kbit/s</translation>
    </message>
    <message>
        <source>%1: refused by the database (%2)</source>
        <translation>%1&#xa0;: refusé par la base de données (%2)</translation>
    </message>
    <message>
        <source>%1: the database is damaged</source>
        <translation>%1&#xa0;: la base de données est endommagée</translation>
    </message>
    <message>
        <source>%1: the database is locked by another program</source>
        <translation>%1&#xa0;: la base de données est verrouillée par un autre programme</translation>
    </message>
    <message>
        <source>%1: the disk is full or does not answer</source>
        <translation>%1&#xa0;: le disque est plein ou ne répond pas</translation>
    </message>
    <message>
        <source>%1: the file or its folder is not writable</source>
        <translation>%1&#xa0;: le fichier ou son dossier n’est pas accessible en écriture</translation>
    </message>
    <message>
        <source>&apos;%1&apos; appears twice</source>
        <translation>«&#xa0;%1&#xa0;» apparaît deux fois</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no difficulty to adapt</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas de difficulté à adapter</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no digit, so it could be a name or initials</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas de chiffre et pourrait être un nom ou des initiales</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds what reads as a date</source>
        <translation>«&#xa0;%1&#xa0;» contient ce qui ressemble à une date</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is before %2</source>
        <translation>«&#xa0;%1&#xa0;» est avant %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no address in numbers</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une adresse en chiffres</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no day of the calendar</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un jour du calendrier</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no kind of treatment</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un type de traitement</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no scale that is known</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une échelle connue</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a digit</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un doigt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a direction</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une direction</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a finite number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a force</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une force</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a hand</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une main</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that makes sense here</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre plausible ici</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that this parameter takes</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre que ce paramètre accepte</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a positive number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre positif</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a unit that is known here</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une unité connue ici</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not in the years %2 to %3</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas dans les années %2 à %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas connu</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not six numbers</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une suite de six nombres</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the expected format</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas le format attendu</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a scene</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas le nom d’une scène</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a task file</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas le nom d’un fichier de tâche</translation>
    </message>
    <message>
        <source>, group %1, second %2</source>
        <translation>, groupe %1, seconde %2</translation>
    </message>
    <message>
        <source>, group %1, seconds %2 to %3</source>
        <translation>, groupe %1, secondes %2 à %3</translation>
    </message>
    <message>
        <source>0 is out of range</source>
        <translation>0 est hors limites</translation>
    </message>
    <message>
        <source>ATI NETCANOEM on %1</source>
        <translation>ATI NETCANOEM sur %1</translation>
    </message>
    <message>
        <source>ATI Net F/T on %1</source>
        <translation>ATI Net F/T sur %1</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>adresse déjà utilisée</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>mémoire insuffisante</translation>
    </message>
    <message>
        <source>Cannot assign requested address</source>
        <translation>impossible d’attribuer l’adresse demandée</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>connexion refusée</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>connexion coupée par l’autre côté</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>délai de connexion dépassé</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>périphérique occupé</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>dossier non vide</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>quota de disque dépassé</translation>
    </message>
    <message>
        <source>Error while parsing %1: %2</source>
        <translation>erreur de lecture (%1)&#xa0;: %2</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>le fichier existe déjà</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>nom de fichier trop long</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>erreur d’entrée/sortie</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>argument non valide</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>est un dossier</translation>
    </message>
    <message>
        <source>JR3 PCI on %1</source>
        <translation>JR3 PCI sur %1</translation>
    </message>
    <message>
        <source>JR3 with CAN adaptor on %1</source>
        <translation>JR3 avec adaptateur CAN sur %1</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>réseau désactivé</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>réseau inaccessible</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>aucun chemin vers l’appareil</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>plus d’espace sur le disque</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>périphérique introuvable</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>périphérique ou adresse introuvable</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>fichier ou dossier introuvable</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>n’est pas un dossier</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>opération non autorisée</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permission refusée</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>système de fichiers en lecture seule</translation>
    </message>
    <message>
        <source>Recorded forces, %1</source>
        <translation>Forces enregistrées, %1</translation>
    </message>
    <message>
        <source>Recorded frames of ATI NETCANOEM, %1</source>
        <translation>Trames enregistrées de ATI NETCANOEM, %1</translation>
    </message>
    <message>
        <source>Recorded frames of ATI Net F/T, %1</source>
        <translation>Trames enregistrées de ATI Net F/T, %1</translation>
    </message>
    <message>
        <source>Recorded frames of JR3 PCI, %1</source>
        <translation>Trames enregistrées de JR3 PCI, %1</translation>
    </message>
    <message>
        <source>Recorded frames of JR3 with CAN adaptor, %1</source>
        <translation>Trames enregistrées de JR3 avec adaptateur CAN, %1</translation>
    </message>
    <message>
        <source>Recorded frames of Robotous RFT, %1</source>
        <translation>Trames enregistrées de Robotous RFT, %1</translation>
    </message>
    <message>
        <source>Robotous RFT on %1</source>
        <translation>Robotous RFT sur %1</translation>
    </message>
    <message>
        <source>Simulated sensors, %1 patient</source>
        <translation>Capteurs simulés, patient&#xa0;: %1</translation>
    </message>
    <message>
        <source>Text file busy</source>
        <translation>fichier en cours d’exécution</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>trop de liens enchaînés</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>trop de fichiers ouverts</translation>
    </message>
    <message>
        <source>a &apos;%&apos; without two hexadecimal digits</source>
        <translation>un «&#xa0;%&#xa0;» sans deux chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>a calibration belongs to one sensor, and none is named here</source>
        <translation>un étalonnage appartient à un capteur, et aucun n’est nommé ici</translation>
    </message>
    <message>
        <source>a comment or whitespace</source>
        <translation>un commentaire ou un espace</translation>
    </message>
    <message>
        <source>a course needs a day</source>
        <translation>une évolution exige un jour</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>une date ou une heure</translation>
    </message>
    <message>
        <source>a frame without &apos;#&apos;</source>
        <translation>une trame sans «&#xa0;#&#xa0;»</translation>
    </message>
    <message>
        <source>a hold of %1 s is not possible</source>
        <translation>un pas de %1 s n’est pas possible</translation>
    </message>
    <message>
        <source>a maximum is measured above the resting force, which no earlier step measures</source>
        <translation>un maximum est mesuré au-dessus de la force de repos, qu’aucune étape antérieure ne mesure</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a quaternion of length zero</source>
        <translation>un quaternion de longueur nulle</translation>
    </message>
    <message>
        <source>a rating that is not positive</source>
        <translation>une valeur nominale non positive</translation>
    </message>
    <message>
        <source>a real bus does not run in virtual time</source>
        <translation>un bus réel ne fonctionne pas en temps virtuel</translation>
    </message>
    <message>
        <source>a real device cannot run in virtual time</source>
        <translation>un appareil réel ne peut pas fonctionner en temps virtuel</translation>
    </message>
    <message>
        <source>a second follows one that was not full</source>
        <translation>une seconde suit une seconde incomplète</translation>
    </message>
    <message>
        <source>a session in real time is not recorded into a scratch file</source>
        <translation>une séance en temps réel n’est pas enregistrée dans un fichier jetable</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>une table</translation>
    </message>
    <message>
        <source>a time without &apos;)&apos;</source>
        <translation>un temps sans «&#xa0;)&#xa0;»</translation>
    </message>
    <message>
        <source>a travel limit of %1 has no meaning while all three rotations are free</source>
        <translation>une butée de %1 n’a pas de sens tant que les trois rotations sont libres</translation>
    </message>
    <message>
        <source>a travel limit of %1 while springs or dampers at an angle couple the axes</source>
        <translation>une butée de %1 alors que des ressorts ou amortisseurs obliques couplent les axes</translation>
    </message>
    <message>
        <source>a trial cannot end as running</source>
        <translation>un essai ne peut pas se terminer comme étant en cours</translation>
    </message>
    <message>
        <source>a trial is being recorded</source>
        <translation>un essai est en cours d’enregistrement</translation>
    </message>
    <message>
        <source>add %1 or %2</source>
        <translation>ajouter %1 ou %2</translation>
    </message>
    <message>
        <source>add ?protocol=rft or ?config=FILE</source>
        <translation>ajouter&#xa0;?protocol=rft ou&#xa0;?config=FICHIER</translation>
    </message>
    <message>
        <source>add a [[finger]] table for each sensor</source>
        <translation>ajouter une table [[finger]] pour chaque capteur</translation>
    </message>
    <message>
        <source>add a [[sensor]] with finger = &quot;%1&quot;</source>
        <translation>ajouter [[sensor]] avec finger = &quot;%1&quot;</translation>
    </message>
    <message>
        <source>add a [difficulty] table to the task, or leave out adaptive</source>
        <translation>ajouter une table [difficulty] à la tâche, ou omettre adaptive</translation>
    </message>
    <message>
        <source>add at least one [[axis]]</source>
        <translation>ajouter au moins un [[axis]]</translation>
    </message>
    <message>
        <source>add at least one [[item]]</source>
        <translation>ajouter au moins un [[item]]</translation>
    </message>
    <message>
        <source>add at least one [[step]]</source>
        <translation>ajouter au moins un [[step]]</translation>
    </message>
    <message>
        <source>add at least one [[target]]</source>
        <translation>ajouter au moins un [[target]]</translation>
    </message>
    <message>
        <source>add columns such as thumb_fx_N, thumb_fy_N, thumb_fz_N</source>
        <translation>ajouter des colonnes comme thumb_fx_N, thumb_fy_N, thumb_fz_N</translation>
    </message>
    <message>
        <source>add e.g. thumb_direction = [0, 0, 1]</source>
        <translation>ajouter p. ex. thumb_direction = [0, 0, 1]</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>l’ajouter</translation>
    </message>
    <message>
        <source>add the column</source>
        <translation>ajouter la colonne</translation>
    </message>
    <message>
        <source>add the time of each row in seconds</source>
        <translation>ajouter le temps de chaque ligne en secondes</translation>
    </message>
    <message>
        <source>adding a patient</source>
        <translation>ajout d’un patient</translation>
    </message>
    <message>
        <source>adding an account</source>
        <translation>ajout d’un compte</translation>
    </message>
    <message>
        <source>administrator</source>
        <translation>administrateur</translation>
    </message>
    <message>
        <source>align them, or write wrench_frame = &quot;hand&quot;</source>
        <translation>les aligner, ou écrire wrench_frame = &quot;hand&quot;</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>an identifier that has neither 3 nor 8 hexadecimal digits</source>
        <translation>un identifiant qui n’a ni 3 ni 8 chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>an identifier that is too large</source>
        <translation>un identifiant trop grand</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>un entier</translation>
    </message>
    <message>
        <source>another file has this name now</source>
        <translation>un autre fichier porte maintenant ce nom</translation>
    </message>
    <message>
        <source>another program has changed the file meanwhile</source>
        <translation>un autre programme a modifié le fichier entre-temps</translation>
    </message>
    <message>
        <source>another program has changed this file meanwhile</source>
        <translation>un autre programme a modifié ce fichier entre-temps</translation>
    </message>
    <message>
        <source>another program has it open</source>
        <translation>un autre programme l’a ouverte</translation>
    </message>
    <message>
        <source>another program records into it now</source>
        <translation>un autre programme y enregistre en ce moment</translation>
    </message>
    <message>
        <source>another program records into the file now</source>
        <translation>un autre programme enregistre dans le fichier en ce moment</translation>
    </message>
    <message>
        <source>append one second at a time</source>
        <translation>ajouter une seconde à la fois</translation>
    </message>
    <message>
        <source>append the seconds in order</source>
        <translation>ajouter les secondes dans l’ordre</translation>
    </message>
    <message>
        <source>are fewer than two</source>
        <translation>sont moins de deux</translation>
    </message>
    <message>
        <source>are too many</source>
        <translation>sont trop nombreux</translation>
    </message>
    <message>
        <source>array</source>
        <translation>liste</translation>
    </message>
    <message>
        <source>ask an administrator to put you into the group dialout</source>
        <translation>demander à un administrateur de vous ajouter au groupe dialout</translation>
    </message>
    <message>
        <source>asks for more than the whole force</source>
        <translation>demande plus que toute la force</translation>
    </message>
    <message>
        <source>asks for no login</source>
        <translation>ne demande pas de connexion</translation>
    </message>
    <message>
        <source>asks no digit</source>
        <translation>ne demande aucun doigt</translation>
    </message>
    <message>
        <source>attempts can only agree with each other</source>
        <translation>seuls des essais peuvent concorder entre eux</translation>
    </message>
    <message>
        <source>bare key starting character or string delimiter</source>
        <translation>début de clé ou guillemet</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>base %1</translation>
    </message>
    <message>
        <source>begin a new session</source>
        <translation>commencer une nouvelle séance</translation>
    </message>
    <message>
        <source>begin it first</source>
        <translation>le commencer d’abord</translation>
    </message>
    <message>
        <source>begin one</source>
        <translation>en commencer une</translation>
    </message>
    <message>
        <source>beginning a session</source>
        <translation>début d’une séance</translation>
    </message>
    <message>
        <source>beginning a trial</source>
        <translation>début d’un essai</translation>
    </message>
    <message>
        <source>blocks for %1 instead of %2 groups</source>
        <translation>blocs pour %1 groupes au lieu de %2</translation>
    </message>
    <message>
        <source>boolean</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>calibration slot %1 holds a matrix, counts or units that cannot be used</source>
        <translation>l’emplacement d’étalonnage %1 contient une matrice, des comptes ou des unités inutilisables</translation>
    </message>
    <message>
        <source>calibration slot %1 was asked for, it chose slot %2</source>
        <translation>l’emplacement d’étalonnage %1 était demandé, il a choisi l’emplacement %2</translation>
    </message>
    <message>
        <source>cannot be a file here</source>
        <translation>ne peut pas être un fichier ici</translation>
    </message>
    <message>
        <source>cannot be locked: %1</source>
        <translation>ne peut pas être verrouillé&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>ne peut pas être créé&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot be opened for %1</source>
        <translation>ne peut pas être ouvert (%1)</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>ne peut pas être ouvert&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot be reached</source>
        <translation>est inaccessible</translation>
    </message>
    <message>
        <source>cannot be reached: %1</source>
        <translation>est inaccessible&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ne peut pas être lu</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>cannot be renamed: %1</source>
        <translation>ne peut pas être renommé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the PIN cannot be used now</source>
        <translation>le PIN ne peut pas être utilisé maintenant</translation>
    </message>
    <message>
        <source>cannot be written, so the reading of an identity could not be logged</source>
        <translation>ne peut pas être écrit, la lecture d’une identité ne pourrait donc pas être journalisée</translation>
    </message>
    <message>
        <source>cannot redefine existing %1 &apos;%2&apos;</source>
        <translation>existe déjà (%1) et ne peut pas être redéfini&#xa0;: «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>cannot redefine existing %1 &apos;%2&apos; as %3</source>
        <translation>existe déjà (%1) et ne peut pas être redéfini&#xa0;: «&#xa0;%2&#xa0;» comme %3</translation>
    </message>
    <message>
        <source>changes nothing</source>
        <translation>ne change rien</translation>
    </message>
    <message>
        <source>changing the user</source>
        <translation>changement d’utilisateur</translation>
    </message>
    <message>
        <source>check --patient and --session (1 is the patient&apos;s first)</source>
        <translation>vérifier --patient et --session (1 est la première du patient)</translation>
    </message>
    <message>
        <source>check its cable; after it was plugged in the card needs ten seconds</source>
        <translation>vérifier son câble&#xa0;; après le branchement, la carte a besoin de dix secondes</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>vérifier ses droits d’accès</translation>
    </message>
    <message>
        <source>check its power, its cable and its address</source>
        <translation>vérifier son alimentation, son câble et son adresse</translation>
    </message>
    <message>
        <source>check its power, its cable and the 120 ohm at both ends of the bus</source>
        <translation>vérifier son alimentation, son câble et les 120 ohms aux deux bouts du bus</translation>
    </message>
    <message>
        <source>check its power, its cable, its address and the baud rate</source>
        <translation>vérifier son alimentation, son câble, son adresse et le débit en bauds</translation>
    </message>
    <message>
        <source>check protocol and addresses of the device file</source>
        <translation>vérifier le protocole et les adresses du fichier de l’appareil</translation>
    </message>
    <message>
        <source>check rate and filter_Hz against the sensor&apos;s model</source>
        <translation>comparer rate et filter_Hz au modèle du capteur</translation>
    </message>
    <message>
        <source>check that it is a log</source>
        <translation>vérifier que c’est un journal</translation>
    </message>
    <message>
        <source>check that it is a log of this protocol</source>
        <translation>vérifier que c’est un journal de ce protocole</translation>
    </message>
    <message>
        <source>check that it is a table of numbers with line ends</source>
        <translation>vérifier que c’est un tableau de nombres avec fins de ligne</translation>
    </message>
    <message>
        <source>check that it is the right file</source>
        <translation>vérifier que c’est le bon fichier</translation>
    </message>
    <message>
        <source>check that the driver jr3_pci is loaded and that you may read the file</source>
        <translation>vérifier que le pilote jr3_pci est chargé et que vous pouvez lire le fichier</translation>
    </message>
    <message>
        <source>check that the kernel modules can and can_raw are loaded</source>
        <translation>vérifier que les modules noyau can et can_raw sont chargés</translation>
    </message>
    <message>
        <source>check the adapter and its cable</source>
        <translation>vérifier l’adaptateur et son câble</translation>
    </message>
    <message>
        <source>check the code</source>
        <translation>vérifier le code</translation>
    </message>
    <message>
        <source>check the code, or record a session with it first</source>
        <translation>vérifier le code, ou enregistrer d’abord une séance avec lui</translation>
    </message>
    <message>
        <source>check the device&apos;s power, its network cable and its address</source>
        <translation>vérifier l’alimentation, le câble réseau et l’adresse de l’appareil</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>vérifier le disque</translation>
    </message>
    <message>
        <source>check the disk and the folder</source>
        <translation>vérifier le disque et le dossier</translation>
    </message>
    <message>
        <source>check the disk and the permissions</source>
        <translation>vérifier le disque et les droits d’accès</translation>
    </message>
    <message>
        <source>check the disk and the permissions of its folder</source>
        <translation>vérifier le disque et les droits d’accès de son dossier</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>vérifier le chemin</translation>
    </message>
    <message>
        <source>check the path and its permissions</source>
        <translation>vérifier le chemin et ses droits d’accès</translation>
    </message>
    <message>
        <source>check the permissions of both, or copy the file to a writable folder</source>
        <translation>vérifier les droits des deux, ou copier le fichier dans un dossier accessible en écriture</translation>
    </message>
    <message>
        <source>check the permissions of the file and its folder</source>
        <translation>vérifier les droits d’accès du fichier et de son dossier</translation>
    </message>
    <message>
        <source>check the permissions of the folder</source>
        <translation>vérifier les droits d’accès du dossier</translation>
    </message>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>choisir un dossier où vous pouvez écrire</translation>
    </message>
    <message>
        <source>choose a level of at least %1, or a wider band</source>
        <translation>choisir un niveau d’au moins %1, ou une bande plus large</translation>
    </message>
    <message>
        <source>choose a longer one; several words are easy to keep in mind</source>
        <translation>en choisir un plus long&#xa0;; plusieurs mots se retiennent facilement</translation>
    </message>
    <message>
        <source>choose a lower level</source>
        <translation>choisir un niveau plus bas</translation>
    </message>
    <message>
        <source>choose a scene in which it can turn about one alone</source>
        <translation>choisir une scène où il peut tourner autour d’un seul</translation>
    </message>
    <message>
        <source>choose an empty folder for --out</source>
        <translation>choisir un dossier vide pour --out</translation>
    </message>
    <message>
        <source>choose another code</source>
        <translation>choisir un autre code</translation>
    </message>
    <message>
        <source>choose another factor</source>
        <translation>choisir un autre facteur</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>choisir un autre dossier</translation>
    </message>
    <message>
        <source>choose another name or folder</source>
        <translation>choisir un autre nom ou dossier</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>en choisir un autre</translation>
    </message>
    <message>
        <source>choose another one: the audit log names people</source>
        <translation>en choisir un autre&#xa0;: le journal d’accès nomme des personnes</translation>
    </message>
    <message>
        <source>choose another task, or read the recording with isograsp import</source>
        <translation>choisir une autre tâche, ou lire l’enregistrement avec isograsp import</translation>
    </message>
    <message>
        <source>choose one that is there</source>
        <translation>en choisir un qui existe</translation>
    </message>
    <message>
        <source>clinical score</source>
        <translation>score clinique</translation>
    </message>
    <message>
        <source>close it and start again</source>
        <translation>la fermer et recommencer</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>fermer les autres programmes</translation>
    </message>
    <message>
        <source>close other programs and try again</source>
        <translation>fermer les autres programmes et réessayer</translation>
    </message>
    <message>
        <source>close that program or wait until it is done</source>
        <translation>fermer ce programme ou attendre qu’il ait fini</translation>
    </message>
    <message>
        <source>close that program, then restore</source>
        <translation>fermer ce programme, puis restaurer</translation>
    </message>
    <message>
        <source>closing a trial</source>
        <translation>clôture d’un essai</translation>
    </message>
    <message>
        <source>comfortable force</source>
        <translation>force confortable</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>virgule</translation>
    </message>
    <message>
        <source>comma or closing &apos;]&apos;</source>
        <translation>virgule ou «&#xa0;]&#xa0;»</translation>
    </message>
    <message>
        <source>comma or closing &apos;}&apos;</source>
        <translation>virgule ou «&#xa0;}&#xa0;»</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>commentaire</translation>
    </message>
    <message>
        <source>connect the right sensor or correct serial_number</source>
        <translation>brancher le bon capteur ou corriger serial_number</translation>
    </message>
    <message>
        <source>copy all 56 digits from the printed page</source>
        <translation>recopier les 56 chiffres de la page imprimée</translation>
    </message>
    <message>
        <source>copy the file to where you may write</source>
        <translation>copier le fichier là où vous pouvez écrire</translation>
    </message>
    <message>
        <source>correct or remove the calibration file</source>
        <translation>corriger ou retirer le fichier d’étalonnage</translation>
    </message>
    <message>
        <source>correct subdevice in the configuration: the first sensor is 0</source>
        <translation>corriger subdevice dans la configuration&#xa0;: le premier capteur est 0</translation>
    </message>
    <message>
        <source>correct the mapping; the file has: %1</source>
        <translation>corriger la correspondance&#xa0;; le fichier a&#xa0;: %1</translation>
    </message>
    <message>
        <source>correct the number, or the scale of the mapping</source>
        <translation>corriger le nombre, ou l’échelle de la correspondance</translation>
    </message>
    <message>
        <source>correct the syntax</source>
        <translation>corriger la syntaxe</translation>
    </message>
    <message>
        <source>could not be made</source>
        <translation>n’a pas pu être créé</translation>
    </message>
    <message>
        <source>could not be made: %1</source>
        <translation>n’a pas pu être créé&#xa0;: %1</translation>
    </message>
    <message>
        <source>could not be written completely</source>
        <translation>n’a pas pu être écrit entièrement</translation>
    </message>
    <message>
        <source>could not determine value type</source>
        <translation>le type de la valeur n’est pas reconnu</translation>
    </message>
    <message>
        <source>damaged (checksum)</source>
        <translation>endommagé (somme de contrôle)</translation>
    </message>
    <message>
        <source>damaged (content hash)</source>
        <translation>endommagé (empreinte du contenu)</translation>
    </message>
    <message>
        <source>damaged (content)</source>
        <translation>endommagé (contenu)</translation>
    </message>
    <message>
        <source>data of a CAN FD frame that cannot be read</source>
        <translation>des données d’une trame CAN FD illisibles</translation>
    </message>
    <message>
        <source>data that are not up to 8 bytes of two hexadecimal digits</source>
        <translation>des données qui ne sont pas jusqu’à 8 octets de deux chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>date</source>
        <translation>date</translation>
    </message>
    <message>
        <source>date-time</source>
        <translation>date et heure</translation>
    </message>
    <message>
        <source>date-time offset</source>
        <translation>décalage horaire</translation>
    </message>
    <message>
        <source>decimal digit</source>
        <translation>un chiffre décimal</translation>
    </message>
    <message>
        <source>differs from the time in %1</source>
        <translation>diffère du temps dans %1</translation>
    </message>
    <message>
        <source>digit</source>
        <translation>un chiffre</translation>
    </message>
    <message>
        <source>do not measure with it: have the sensor checked or correct the configuration</source>
        <translation>ne pas mesurer avec&#xa0;: faire vérifier le capteur ou corriger la configuration</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>n’existe pas</translation>
    </message>
    <message>
        <source>does not increase</source>
        <translation>n’augmente pas</translation>
    </message>
    <message>
        <source>does not tell its rate</source>
        <translation>n’indique pas sa cadence</translation>
    </message>
    <message>
        <source>duplicate it first</source>
        <translation>le dupliquer d’abord</translation>
    </message>
    <message>
        <source>duplicate your text, then Revert shows what stands there</source>
        <translation>dupliquer votre texte, puis «&#xa0;Rétablir&#xa0;» montre ce qui s’y trouve</translation>
    </message>
    <message>
        <source>encountered end-of-file</source>
        <translation>la fin du fichier est venue trop tôt</translation>
    </message>
    <message>
        <source>end it before the next one begins</source>
        <translation>le terminer avant que le suivant commence</translation>
    </message>
    <message>
        <source>end that session, then erase</source>
        <translation>terminer cette séance, puis effacer</translation>
    </message>
    <message>
        <source>end that session, then migrate</source>
        <translation>terminer cette séance, puis migrer</translation>
    </message>
    <message>
        <source>end that session, then restore</source>
        <translation>terminer cette séance, puis restaurer</translation>
    </message>
    <message>
        <source>end the trial after the last second</source>
        <translation>terminer l’essai après la dernière seconde</translation>
    </message>
    <message>
        <source>ending a session</source>
        <translation>fin d’une séance</translation>
    </message>
    <message>
        <source>ends after %1 rows, before %2</source>
        <translation>se termine après %1 lignes, avant %2</translation>
    </message>
    <message>
        <source>erasing a person</source>
        <translation>effacement d’une personne</translation>
    </message>
    <message>
        <source>exceeded maximum nested value depth of %1</source>
        <translation>imbrication de plus de %1</translation>
    </message>
    <message>
        <source>exchange the two</source>
        <translation>échanger les deux</translation>
    </message>
    <message>
        <source>exists already</source>
        <translation>existe déjà</translation>
    </message>
    <message>
        <source>expected %1, saw %2</source>
        <translation>attendu&#xa0;: %1, trouvé&#xa0;: %2</translation>
    </message>
    <message>
        <source>exponent digit</source>
        <translation>un chiffre de l’exposant</translation>
    </message>
    <message>
        <source>exponent digit or sign</source>
        <translation>un chiffre ou le signe de l’exposant</translation>
    </message>
    <message>
        <source>fewer than two rows</source>
        <translation>moins de deux lignes</translation>
    </message>
    <message>
        <source>floating-point</source>
        <translation>nombre décimal</translation>
    </message>
    <message>
        <source>fractional digits</source>
        <translation>des décimales</translation>
    </message>
    <message>
        <source>free one rotation or all three</source>
        <translation>libérer une rotation ou les trois</translation>
    </message>
    <message>
        <source>free some disk space and check the permissions of the folder</source>
        <translation>libérer de l’espace disque et vérifier les droits d’accès du dossier</translation>
    </message>
    <message>
        <source>free some space; everything confirmed before is stored</source>
        <translation>libérer de l’espace&#xa0;; tout ce qui a été confirmé avant est enregistré</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>indiquer %1</translation>
    </message>
    <message>
        <source>give --passphrase-file, or --user and --password-file</source>
        <translation>indiquer --passphrase-file, ou --user et --password-file</translation>
    </message>
    <message>
        <source>give 0 (never wait) or 0.01 to 1000</source>
        <translation>indiquer 0 (ne jamais attendre) ou 0.01 à 1000</translation>
    </message>
    <message>
        <source>give 1 or -1</source>
        <translation>indiquer 1 ou -1</translation>
    </message>
    <message>
        <source>give 1 to 64 characters on one line, no blank at either end</source>
        <translation>indiquer 1 à 64 caractères sur une ligne, sans espace au bord</translation>
    </message>
    <message>
        <source>give a CSV file whose first line names the columns</source>
        <translation>indiquer un fichier CSV dont la première ligne nomme les colonnes</translation>
    </message>
    <message>
        <source>give a database that is kept</source>
        <translation>indiquer une base de données conservée</translation>
    </message>
    <message>
        <source>give a file made by isograsp db init</source>
        <translation>indiquer un fichier créé par isograsp db init</translation>
    </message>
    <message>
        <source>give a file whose first line is: format = &quot;%1&quot;</source>
        <translation>indiquer un fichier dont la première ligne est&#xa0;: format = &quot;%1&quot;</translation>
    </message>
    <message>
        <source>give a log with lines like %1</source>
        <translation>indiquer un journal avec des lignes comme %1</translation>
    </message>
    <message>
        <source>give a lower fir_cutoff_Hz</source>
        <translation>indiquer une fir_cutoff_Hz plus basse</translation>
    </message>
    <message>
        <source>give a number above 0</source>
        <translation>indiquer un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>give a rate of 50 to 1000 Hz</source>
        <translation>indiquer une cadence de 50 à 1000 Hz</translation>
    </message>
    <message>
        <source>give a year from %1 on</source>
        <translation>indiquer une année à partir de %1</translation>
    </message>
    <message>
        <source>give address for each [[sensor]]</source>
        <translation>indiquer address pour chaque [[sensor]]</translation>
    </message>
    <message>
        <source>give all groups of the trial at once</source>
        <translation>indiquer tous les groupes de l’essai à la fois</translation>
    </message>
    <message>
        <source>give an odd number from 3 to %1</source>
        <translation>indiquer un nombre impair de 3 à %1</translation>
    </message>
    <message>
        <source>give an odd number of taps</source>
        <translation>indiquer un nombre impair de coefficients</translation>
    </message>
    <message>
        <source>give another name</source>
        <translation>indiquer un autre nom</translation>
    </message>
    <message>
        <source>give at least one group</source>
        <translation>indiquer au moins un groupe</translation>
    </message>
    <message>
        <source>give at least two moments, or none</source>
        <translation>indiquer au moins deux moments, ou aucun</translation>
    </message>
    <message>
        <source>give at least two rows</source>
        <translation>indiquer au moins deux lignes</translation>
    </message>
    <message>
        <source>give at most 1024 characters</source>
        <translation>indiquer au plus 1024 caractères</translation>
    </message>
    <message>
        <source>give each finger once</source>
        <translation>indiquer chaque doigt une fois</translation>
    </message>
    <message>
        <source>give either the rate or the column that holds the time</source>
        <translation>indiquer soit la cadence, soit la colonne du temps</translation>
    </message>
    <message>
        <source>give every group one row per sample</source>
        <translation>donner à chaque groupe une ligne par échantillon</translation>
    </message>
    <message>
        <source>give every line %1 fields</source>
        <translation>donner %1 champs à chaque ligne</translation>
    </message>
    <message>
        <source>give every row a time</source>
        <translation>donner un temps à chaque ligne</translation>
    </message>
    <message>
        <source>give every sensor its own</source>
        <translation>donner à chaque capteur le sien</translation>
    </message>
    <message>
        <source>give it damping, or the object mass</source>
        <translation>lui donner un amortissement, ou une masse à l’objet</translation>
    </message>
    <message>
        <source>give it once</source>
        <translation>l’indiquer une fois</translation>
    </message>
    <message>
        <source>give logs of the same length</source>
        <translation>indiquer des journaux de même longueur</translation>
    </message>
    <message>
        <source>give more taps, a higher fir_cutoff_Hz or a lower rate_Hz</source>
        <translation>indiquer plus de coefficients, une fir_cutoff_Hz plus haute ou une rate_Hz plus basse</translation>
    </message>
    <message>
        <source>give one from %1 to %2</source>
        <translation>en indiquer un de %1 à %2</translation>
    </message>
    <message>
        <source>give one of: %1</source>
        <translation>indiquer l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>give the last day of that time</source>
        <translation>indiquer le dernier jour de cette période</translation>
    </message>
    <message>
        <source>give the person&apos;s name</source>
        <translation>indiquer le nom de la personne</translation>
    </message>
    <message>
        <source>give the sensor&apos;s serial_number too</source>
        <translation>indiquer aussi le serial_number du capteur</translation>
    </message>
    <message>
        <source>give the value, or leave all fields of the finger empty</source>
        <translation>indiquer la valeur, ou laisser vides tous les champs du doigt</translation>
    </message>
    <message>
        <source>give three numbers above 0</source>
        <translation>indiquer trois nombres supérieurs à 0</translation>
    </message>
    <message>
        <source>give times that increase</source>
        <translation>indiquer des temps croissants</translation>
    </message>
    <message>
        <source>give true wrench = matrix * sensor&apos;s wrench, both in N and N m</source>
        <translation>indiquer torseur vrai = matrice * torseur du capteur, tous deux en N et N m</translation>
    </message>
    <message>
        <source>give two directions that are not parallel</source>
        <translation>indiquer deux directions non parallèles</translation>
    </message>
    <message>
        <source>give values as docs/file_formats.md describes them</source>
        <translation>indiquer des valeurs conformes à docs/file_formats.md</translation>
    </message>
    <message>
        <source>give w, x, y, z of a rotation</source>
        <translation>indiquer w, x, y, z d’une rotation</translation>
    </message>
    <message>
        <source>give year, month and day, such as 1950-03-05</source>
        <translation>indiquer année, mois et jour, par exemple 1950-03-05</translation>
    </message>
    <message>
        <source>give year, month and day, such as 2026-03-05</source>
        <translation>indiquer année, mois et jour, par exemple 2026-03-05</translation>
    </message>
    <message>
        <source>gives too many lines for this duration</source>
        <translation>donne trop de raies pour cette durée</translation>
    </message>
    <message>
        <source>has %1 characters instead of 2 to 32</source>
        <translation>a %1 caractères au lieu de 2 à 32</translation>
    </message>
    <message>
        <source>has a format that this program does not know</source>
        <translation>a un format que ce programme ne connaît pas</translation>
    </message>
    <message>
        <source>has a key of more than %1 parts</source>
        <translation>a une clé de plus de %1 parties</translation>
    </message>
    <message>
        <source>has another length than t_s</source>
        <translation>n’a pas la même longueur que t_s</translation>
    </message>
    <message>
        <source>has fewer than %1 characters</source>
        <translation>a moins de %1 caractères</translation>
    </message>
    <message>
        <source>has no direction</source>
        <translation>n’a pas de direction</translation>
    </message>
    <message>
        <source>has no length</source>
        <translation>n’a pas de longueur</translation>
    </message>
    <message>
        <source>has the level that the step begins at</source>
        <translation>a le niveau où commence l’échelon</translation>
    </message>
    <message>
        <source>has the serial number &apos;%1&apos;, but the configuration says &apos;%2&apos;</source>
        <translation>a le numéro de série «&#xa0;%1&#xa0;», mais la configuration indique «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>has two contacts</source>
        <translation>a deux contacts</translation>
    </message>
    <message>
        <source>has two limits</source>
        <translation>a deux limites</translation>
    </message>
    <message>
        <source>hex digit</source>
        <translation>un chiffre hexadécimal</translation>
    </message>
    <message>
        <source>holds %1 that is not a finite number</source>
        <translation>contient %1, qui n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>holds %1, not a table</source>
        <translation>contient %1 au lieu d’une table</translation>
    </message>
    <message>
        <source>holds %1, not text</source>
        <translation>contient %1 au lieu de texte</translation>
    </message>
    <message>
        <source>holds a character other than letters, digits and &apos;-&apos;</source>
        <translation>contient un caractère autre que lettres, chiffres et «&#xa0;-&#xa0;»</translation>
    </message>
    <message>
        <source>holds a control character</source>
        <translation>contient un caractère de commande</translation>
    </message>
    <message>
        <source>holds a zero byte</source>
        <translation>contient un octet nul</translation>
    </message>
    <message>
        <source>holds no finger&apos;s forces</source>
        <translation>ne contient les forces d’aucun doigt</translation>
    </message>
    <message>
        <source>holds no frame</source>
        <translation>ne contient aucune trame</translation>
    </message>
    <message>
        <source>holds no header line</source>
        <translation>ne contient pas de ligne d’en-tête</translation>
    </message>
    <message>
        <source>holds no sample of these sensors</source>
        <translation>ne contient aucun échantillon de ces capteurs</translation>
    </message>
    <message>
        <source>holds no such trial</source>
        <translation>ne contient pas cet essai</translation>
    </message>
    <message>
        <source>identifier %1</source>
        <translation>identifiant %1</translation>
    </message>
    <message>
        <source>identities are not stored in a database without protection</source>
        <translation>les identités ne sont pas enregistrées dans une base sans protection</translation>
    </message>
    <message>
        <source>in an emergency give the reason; it is logged</source>
        <translation>en cas d’urgence, indiquer la raison&#xa0;; elle est journalisée</translation>
    </message>
    <message>
        <source>index</source>
        <translation>index (doigt)</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>inertie</translation>
    </message>
    <message>
        <source>inline table</source>
        <translation>table en ligne</translation>
    </message>
    <message>
        <source>install libcomedi-dev and build it again</source>
        <translation>installer libcomedi-dev et recompiler le programme</translation>
    </message>
    <message>
        <source>install the newer program; report and export still read it if they can</source>
        <translation>installer le programme plus récent&#xa0;; rapport et export la lisent encore si possible</translation>
    </message>
    <message>
        <source>is %1, not a finite number</source>
        <translation>est %1, pas un nombre fini</translation>
    </message>
    <message>
        <source>is %1, not a list of tables</source>
        <translation>est %1, pas une liste de tables</translation>
    </message>
    <message>
        <source>is %1, not a table</source>
        <translation>est %1, pas une table</translation>
    </message>
    <message>
        <source>is %1, not an array of %2 numbers</source>
        <translation>est %1, pas une liste de %2 nombres</translation>
    </message>
    <message>
        <source>is %1, not an array of texts</source>
        <translation>est %1, pas une liste de textes</translation>
    </message>
    <message>
        <source>is %1, not an integer</source>
        <translation>est %1, pas un entier</translation>
    </message>
    <message>
        <source>is %1, not text</source>
        <translation>est %1, pas du texte</translation>
    </message>
    <message>
        <source>is %1, not true or false</source>
        <translation>est %1, pas true ou false</translation>
    </message>
    <message>
        <source>is 0 on the free axis %1 that has no %2</source>
        <translation>vaut 0 sur l’axe libre %1, dépourvu de&#xa0;: %2</translation>
    </message>
    <message>
        <source>is a database of another program</source>
        <translation>est la base de données d’un autre programme</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>est un dossier</translation>
    </message>
    <message>
        <source>is a task of recordings, which nobody can do live</source>
        <translation>est une tâche d’enregistrements que personne ne peut faire en direct</translation>
    </message>
    <message>
        <source>is above %1</source>
        <translation>est au-dessus de %1</translation>
    </message>
    <message>
        <source>is below 2</source>
        <translation>est inférieur à 2</translation>
    </message>
    <message>
        <source>is below least_wait_s</source>
        <translation>est inférieur à least_wait_s</translation>
    </message>
    <message>
        <source>is below one cycle in this duration</source>
        <translation>est inférieur à un cycle pour cette durée</translation>
    </message>
    <message>
        <source>is below repetitions</source>
        <translation>est inférieur à repetitions</translation>
    </message>
    <message>
        <source>is driven twice</source>
        <translation>est entraîné deux fois</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>is larger than 4 MiB</source>
        <translation>dépasse 4 Mio</translation>
    </message>
    <message>
        <source>is larger than 64 MiB</source>
        <translation>dépasse 64 Mio</translation>
    </message>
    <message>
        <source>is locked</source>
        <translation>est verrouillée</translation>
    </message>
    <message>
        <source>is longer than 4096 bytes</source>
        <translation>dépasse 4096 octets</translation>
    </message>
    <message>
        <source>is longer than push_s</source>
        <translation>est plus long que push_s</translation>
    </message>
    <message>
        <source>is longer than reproduce_s</source>
        <translation>est plus long que reproduce_s</translation>
    </message>
    <message>
        <source>is longer than squeeze_s</source>
        <translation>est plus long que squeeze_s</translation>
    </message>
    <message>
        <source>is mapped twice</source>
        <translation>est affecté deux fois</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>is negative</source>
        <translation>est négatif</translation>
    </message>
    <message>
        <source>is no day of the calendar in the years 1900 to 2099</source>
        <translation>n’est pas un jour du calendrier des années 1900 à 2099</translation>
    </message>
    <message>
        <source>is no name of an account</source>
        <translation>n’est pas un nom de compte</translation>
    </message>
    <message>
        <source>is no recovery key: a digit is missing or mistyped</source>
        <translation>n’est pas une clé de secours&#xa0;: un chiffre manque ou est faux</translation>
    </message>
    <message>
        <source>is no window of rows</source>
        <translation>n’est pas une fenêtre de lignes</translation>
    </message>
    <message>
        <source>is not 4 to 12 digits</source>
        <translation>n’a pas 4 à 12 chiffres</translation>
    </message>
    <message>
        <source>is not a closing force</source>
        <translation>n’est pas une force de fermeture</translation>
    </message>
    <message>
        <source>is not a database</source>
        <translation>n’est pas une base de données</translation>
    </message>
    <message>
        <source>is not a plain file</source>
        <translation>n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>is not a whole number</source>
        <translation>n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>is not above the least level</source>
        <translation>n’est pas au-dessus du niveau le plus bas</translation>
    </message>
    <message>
        <source>is not after from_day</source>
        <translation>n’est pas après from_day</translation>
    </message>
    <message>
        <source>is not allowed</source>
        <translation>n’est pas autorisé</translation>
    </message>
    <message>
        <source>is not positive</source>
        <translation>n’est pas positif</translation>
    </message>
    <message>
        <source>is not protected: it has no accounts</source>
        <translation>n’est pas protégée&#xa0;: elle n’a pas de comptes</translation>
    </message>
    <message>
        <source>is nothing that this kind of task has</source>
        <translation>n’existe pas pour ce type de tâche</translation>
    </message>
    <message>
        <source>is or was the name of an account</source>
        <translation>est ou était le nom d’un compte</translation>
    </message>
    <message>
        <source>is out of range</source>
        <translation>est hors limites</translation>
    </message>
    <message>
        <source>is protected, and nobody is logged in</source>
        <translation>est protégée, et personne n’est connecté</translation>
    </message>
    <message>
        <source>is read-only</source>
        <translation>est en lecture seule</translation>
    </message>
    <message>
        <source>is shipped and stays as it is</source>
        <translation>est fourni et reste tel quel</translation>
    </message>
    <message>
        <source>is the backup itself</source>
        <translation>est la sauvegarde elle-même</translation>
    </message>
    <message>
        <source>is the input: it would be lost</source>
        <translation>est l’entrée&#xa0;: elle serait perdue</translation>
    </message>
    <message>
        <source>is the name of %1</source>
        <translation>est le nom de %1</translation>
    </message>
    <message>
        <source>is too easy to guess</source>
        <translation>est trop facile à deviner</translation>
    </message>
    <message>
        <source>is too large in SI units</source>
        <translation>est trop grand en unités SI</translation>
    </message>
    <message>
        <source>is too slow</source>
        <translation>est trop lent</translation>
    </message>
    <message>
        <source>the PIN is wrong</source>
        <translation>le PIN est faux</translation>
    </message>
    <message>
        <source>is zero</source>
        <translation>est nul</translation>
    </message>
    <message>
        <source>is zero or along the normal</source>
        <translation>est nul ou le long de la normale</translation>
    </message>
    <message>
        <source>it does not answer in time</source>
        <translation>il ne répond pas à temps</translation>
    </message>
    <message>
        <source>it holds no force</source>
        <translation>il ne contient pas de force</translation>
    </message>
    <message>
        <source>it holds no path of an object</source>
        <translation>il ne contient pas de trajet d’objet</translation>
    </message>
    <message>
        <source>it refuses the connection</source>
        <translation>il refuse la connexion</translation>
    </message>
    <message>
        <source>it says itself that calibration slot %1 is bad</source>
        <translation>il signale lui-même que l’emplacement d’étalonnage %1 est mauvais</translation>
    </message>
    <message>
        <source>it says that its sensor is not initialised</source>
        <translation>il signale que son capteur n’est pas initialisé</translation>
    </message>
    <message>
        <source>its error code is %1</source>
        <translation>son code d’erreur est %1</translation>
    </message>
    <message>
        <source>its first line is empty</source>
        <translation>sa première ligne est vide</translation>
    </message>
    <message>
        <source>its first line is too long</source>
        <translation>sa première ligne est trop longue</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>son dossier n’existe pas</translation>
    </message>
    <message>
        <source>its folder is read-only</source>
        <translation>son dossier est en lecture seule</translation>
    </message>
    <message>
        <source>its own factor is not between 0.5 and 2: this is no correction</source>
        <translation>son propre facteur n’est pas entre 0.5 et 2&#xa0;: ce n’est pas une correction</translation>
    </message>
    <message>
        <source>keep bandwidth times duration below %1</source>
        <translation>garder bande passante fois durée sous %1</translation>
    </message>
    <message>
        <source>keep it on a local disk</source>
        <translation>la garder sur un disque local</translation>
    </message>
    <message>
        <source>keep one contact per finger</source>
        <translation>garder un contact par doigt</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>en garder un</translation>
    </message>
    <message>
        <source>keep the database on a local disk</source>
        <translation>garder la base de données sur un disque local</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>key or closing &apos;}&apos;</source>
        <translation>clé ou «&#xa0;}&#xa0;»</translation>
    </message>
    <message>
        <source>key-value pair</source>
        <translation>clé avec valeur</translation>
    </message>
    <message>
        <source>key-value pair or closing &apos;}&apos;</source>
        <translation>clé avec valeur ou «&#xa0;}&#xa0;»</translation>
    </message>
    <message>
        <source>keys, tables, whitespace or comments</source>
        <translation>clés, tables, espaces ou commentaires</translation>
    </message>
    <message>
        <source>leading zeroes are prohibited</source>
        <translation>les zéros en tête sont interdits</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>l’omettre</translation>
    </message>
    <message>
        <source>leave it out; the guided check finds exchanged sensors</source>
        <translation>l’omettre&#xa0;; le contrôle guidé trouve les capteurs échangés</translation>
    </message>
    <message>
        <source>leave out --fast</source>
        <translation>omettre --fast</translation>
    </message>
    <message>
        <source>leave out --fast, or use sim:// or replay://</source>
        <translation>omettre --fast, ou utiliser sim:// ou replay://</translation>
    </message>
    <message>
        <source>leave out wrenches that almost coincide</source>
        <translation>omettre les torseurs presque confondus</translation>
    </message>
    <message>
        <source>leave protocol out or use another configuration</source>
        <translation>omettre protocol ou utiliser une autre configuration</translation>
    </message>
    <message>
        <source>leave the login out</source>
        <translation>omettre la connexion</translation>
    </message>
    <message>
        <source>leave the task out, or repeat the screening</source>
        <translation>omettre la tâche, ou répéter les questions préalables</translation>
    </message>
    <message>
        <source>leave the value out and give the reason</source>
        <translation>omettre la valeur et indiquer la raison</translation>
    </message>
    <message>
        <source>leave this person out, or record the consent that was given</source>
        <translation>omettre cette personne, ou enregistrer le consentement donné</translation>
    </message>
    <message>
        <source>leaves no time within time_limit_s</source>
        <translation>ne laisse pas de temps dans time_limit_s</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>let the target turn about rx, ry or rz alone</source>
        <translation>faire tourner la cible autour de rx, ry ou rz seul</translation>
    </message>
    <message>
        <source>libsodium does not start</source>
        <translation>libsodium ne démarre pas</translation>
    </message>
    <message>
        <source>lift the restriction if the person wishes to go on</source>
        <translation>lever la restriction si la personne souhaite continuer</translation>
    </message>
    <message>
        <source>lifting a restriction</source>
        <translation>levée d’une restriction</translation>
    </message>
    <message>
        <source>literal string</source>
        <translation>texte entre guillemets simples</translation>
    </message>
    <message>
        <source>log in again</source>
        <translation>se reconnecter</translation>
    </message>
    <message>
        <source>log in as a therapist</source>
        <translation>se connecter comme thérapeute</translation>
    </message>
    <message>
        <source>log in as an administrator</source>
        <translation>se connecter comme administrateur</translation>
    </message>
    <message>
        <source>log in as somebody else</source>
        <translation>se connecter comme quelqu’un d’autre</translation>
    </message>
    <message>
        <source>log in with a name</source>
        <translation>se connecter avec un nom</translation>
    </message>
    <message>
        <source>log in with the password</source>
        <translation>se connecter avec le mot de passe</translation>
    </message>
    <message>
        <source>logging in</source>
        <translation>connexion</translation>
    </message>
    <message>
        <source>look at its measures</source>
        <translation>regarder ses mesures</translation>
    </message>
    <message>
        <source>make it shorter</source>
        <translation>le raccourcir</translation>
    </message>
    <message>
        <source>make it shorter, or repeat it less often</source>
        <translation>la raccourcir, ou la répéter moins souvent</translation>
    </message>
    <message>
        <source>make it with isograsp db init, or check the path</source>
        <translation>la créer avec isograsp db init, ou vérifier le chemin</translation>
    </message>
    <message>
        <source>make it writable, or copy it to where you may write</source>
        <translation>la rendre accessible en écriture, ou la copier là où vous pouvez écrire</translation>
    </message>
    <message>
        <source>make its folder writable</source>
        <translation>rendre son dossier accessible en écriture</translation>
    </message>
    <message>
        <source>make the folder</source>
        <translation>créer le dossier</translation>
    </message>
    <message>
        <source>make the folder %1</source>
        <translation>créer le dossier %1</translation>
    </message>
    <message>
        <source>make the folder writable</source>
        <translation>rendre le dossier accessible en écriture</translation>
    </message>
    <message>
        <source>make the folder writable, or copy the file to where you may write</source>
        <translation>rendre le dossier accessible en écriture, ou copier le fichier là où vous pouvez écrire</translation>
    </message>
    <message>
        <source>make them all different</source>
        <translation>les rendre tous différents</translation>
    </message>
    <message>
        <source>making the database</source>
        <translation>création de la base de données</translation>
    </message>
    <message>
        <source>making the database: %1</source>
        <translation>création de la base de données&#xa0;: %1</translation>
    </message>
    <message>
        <source>map every finger once</source>
        <translation>affecter chaque doigt une fois</translation>
    </message>
    <message>
        <source>marking a trial</source>
        <translation>marquage d’un essai</translation>
    </message>
    <message>
        <source>marking interrupted trials</source>
        <translation>marquage des essais interrompus</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>masse</translation>
    </message>
    <message>
        <source>maximum force</source>
        <translation>force maximale</translation>
    </message>
    <message>
        <source>may not be read</source>
        <translation>n’a pas le droit d’être lu</translation>
    </message>
    <message>
        <source>measure %1 is not a finite number</source>
        <translation>la mesure %1 n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>measure today&apos;s maximum, or use the task relative to it</source>
        <translation>mesurer le maximum du jour, ou utiliser la tâche relative à celui-ci</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>majeur</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manquant</translation>
    </message>
    <message>
        <source>missing exponent</source>
        <translation>l’exposant manque</translation>
    </message>
    <message>
        <source>move it while it is recorded</source>
        <translation>le déplacer pendant l’enregistrement</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>nommer un fichier</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>y nommer un fichier</translation>
    </message>
    <message>
        <source>name a new file</source>
        <translation>nommer un nouveau fichier</translation>
    </message>
    <message>
        <source>name at least one digit</source>
        <translation>nommer au moins un doigt</translation>
    </message>
    <message>
        <source>name at least one direction</source>
        <translation>nommer au moins une direction</translation>
    </message>
    <message>
        <source>name at least one task</source>
        <translation>nommer au moins une tâche</translation>
    </message>
    <message>
        <source>name every column</source>
        <translation>nommer chaque colonne</translation>
    </message>
    <message>
        <source>name it like thumb_fx_N or thumb_tx_Nm, or remove it</source>
        <translation>la nommer comme thumb_fx_N ou thumb_tx_Nm, ou la retirer</translation>
    </message>
    <message>
        <source>name or password is wrong</source>
        <translation>nom ou mot de passe incorrect</translation>
    </message>
    <message>
        <source>name the card that the driver jr3_pci serves</source>
        <translation>nommer la carte que gère le pilote jr3_pci</translation>
    </message>
    <message>
        <source>name the columns t_s and target</source>
        <translation>nommer les colonnes t_s et target</translation>
    </message>
    <message>
        <source>name the measure</source>
        <translation>nommer la mesure</translation>
    </message>
    <message>
        <source>name the task</source>
        <translation>nommer la tâche</translation>
    </message>
    <message>
        <source>name those that have a column X_fz_N</source>
        <translation>nommer ceux qui ont une colonne X_fz_N</translation>
    </message>
    <message>
        <source>name two files</source>
        <translation>nommer deux fichiers</translation>
    </message>
    <message>
        <source>names no column</source>
        <translation>ne nomme aucune colonne</translation>
    </message>
    <message>
        <source>needs at least 2 levels of each factor</source>
        <translation>exige au moins 2 niveaux de chaque facteur</translation>
    </message>
    <message>
        <source>neither 1 nor -1</source>
        <translation>ni 1 ni -1</translation>
    </message>
    <message>
        <source>no body has one principal moment alone: each is at most the sum of the others</source>
        <translation>aucun corps n’a un seul moment principal&#xa0;: chacun est au plus la somme des autres</translation>
    </message>
    <message>
        <source>no convex hull of these wrenches: %1</source>
        <translation>pas d’enveloppe convexe de ces torseurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>no database file is given</source>
        <translation>aucun fichier de base de données n’est indiqué</translation>
    </message>
    <message>
        <source>no datagram of this log holds records of a Net F/T box</source>
        <translation>aucun datagramme de ce journal ne contient de mesures d’un boîtier Net F/T</translation>
    </message>
    <message>
        <source>no device is called %1://</source>
        <translation>aucun appareil ne s’appelle %1://</translation>
    </message>
    <message>
        <source>no file for the backup is given</source>
        <translation>aucun fichier n’est indiqué pour la sauvegarde</translation>
    </message>
    <message>
        <source>no file is named</source>
        <translation>aucun fichier n’est nommé</translation>
    </message>
    <message>
        <source>no finger is mapped</source>
        <translation>aucun doigt n’est affecté</translation>
    </message>
    <message>
        <source>no interface is named</source>
        <translation>aucune interface n’est nommée</translation>
    </message>
    <message>
        <source>no patient is named</source>
        <translation>aucun patient n’est nommé</translation>
    </message>
    <message>
        <source>no protocol is called &apos;%1&apos;</source>
        <translation>aucun protocole ne s’appelle «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>no row id</source>
        <translation>pas de numéro de ligne</translation>
    </message>
    <message>
        <source>nobody has an account of this name</source>
        <translation>personne n’a de compte de ce nom</translation>
    </message>
    <message>
        <source>nobody has opened the database with a password yet</source>
        <translation>personne n’a encore ouvert la base de données avec un mot de passe</translation>
    </message>
    <message>
        <source>nobody is logged in with an account</source>
        <translation>personne n’est connecté avec un compte</translation>
    </message>
    <message>
        <source>nobody presses the simulated device</source>
        <translation>personne n’appuie sur l’appareil simulé</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>nœud %1</translation>
    </message>
    <message>
        <source>normal and tangent do not span a plane</source>
        <translation>normal et tangent ne définissent pas un plan</translation>
    </message>
    <message>
        <source>not a device URI</source>
        <translation>n’est pas une URI d’appareil</translation>
    </message>
    <message>
        <source>not a finite wrench</source>
        <translation>pas un torseur fini</translation>
    </message>
    <message>
        <source>not a parameter of the form key=value</source>
        <translation>pas un paramètre de la forme key=value</translation>
    </message>
    <message>
        <source>not a time in seconds with 6 or 9 fraction digits</source>
        <translation>pas un temps en secondes avec 6 ou 9 décimales</translation>
    </message>
    <message>
        <source>not above first_id: the bus could turn a pair of frames around</source>
        <translation>pas supérieur à first_id&#xa0;: le bus pourrait intervertir deux trames</translation>
    </message>
    <message>
        <source>not an IPv4 address with a port</source>
        <translation>pas une adresse IPv4 avec port</translation>
    </message>
    <message>
        <source>not an address in numbers</source>
        <translation>pas une adresse en chiffres</translation>
    </message>
    <message>
        <source>not an identifier of this sensor family</source>
        <translation>pas un identifiant de cette famille de capteurs</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>mémoire insuffisante</translation>
    </message>
    <message>
        <source>not enough memory for the key of a password</source>
        <translation>mémoire insuffisante pour la clé d’un mot de passe</translation>
    </message>
    <message>
        <source>not positive</source>
        <translation>pas positif</translation>
    </message>
    <message>
        <source>not the addresses of three sensors</source>
        <translation>pas les adresses de trois capteurs</translation>
    </message>
    <message>
        <source>not valid TOML: %1</source>
        <translation>TOML non valide&#xa0;: %1</translation>
    </message>
    <message>
        <source>not whole bytes of two hexadecimal digits</source>
        <translation>pas des octets entiers de deux chiffres hexadécimaux</translation>
    </message>
    <message>
        <source>one of its full scales is not positive</source>
        <translation>une de ses pleines échelles n’est pas positive</translation>
    </message>
    <message>
        <source>one of its full scales is zero</source>
        <translation>une de ses pleines échelles est nulle</translation>
    </message>
    <message>
        <source>only what is held can be let go</source>
        <translation>seul ce qui est tenu peut être relâché</translation>
    </message>
    <message>
        <source>open it in a session, which brings the simulated patient</source>
        <translation>l’ouvrir dans une séance, qui apporte le patient simulé</translation>
    </message>
    <message>
        <source>open the box&apos;s web page and check its configuration</source>
        <translation>ouvrir la page web du boîtier et vérifier sa configuration</translation>
    </message>
    <message>
        <source>overlaps the stable time from %1 to %2</source>
        <translation>chevauche la période stable du %1 au %2</translation>
    </message>
    <message>
        <source>packing signals</source>
        <translation>compression des signaux</translation>
    </message>
    <message>
        <source>patient %1 exists already</source>
        <translation>le patient %1 existe déjà</translation>
    </message>
    <message>
        <source>patient %1 was erased: the code is not given again</source>
        <translation>le patient %1 a été effacé&#xa0;: le code n’est pas réattribué</translation>
    </message>
    <message>
        <source>patient code</source>
        <translation>code du patient</translation>
    </message>
    <message>
        <source>plug in the CAN adapter and load its driver</source>
        <translation>brancher l’adaptateur CAN et charger son pilote</translation>
    </message>
    <message>
        <source>plug in the adapter and check the name of the port</source>
        <translation>brancher l’adaptateur et vérifier le nom du port</translation>
    </message>
    <message>
        <source>plug in the network cable and give this computer an address in the same network</source>
        <translation>brancher le câble réseau et donner à cet ordinateur une adresse du même réseau</translation>
    </message>
    <message>
        <source>press while it is recorded</source>
        <translation>appuyer pendant l’enregistrement</translation>
    </message>
    <message>
        <source>primary measure</source>
        <translation>mesure principale</translation>
    </message>
    <message>
        <source>program the sensor so that first_id is the smaller one</source>
        <translation>programmer le capteur pour que first_id soit le plus petit</translation>
    </message>
    <message>
        <source>protecting the database</source>
        <translation>protection de la base de données</translation>
    </message>
    <message>
        <source>put a resting-force task before it</source>
        <translation>placer avant elle une tâche de force de repos</translation>
    </message>
    <message>
        <source>put a task that measures it before</source>
        <translation>placer avant elle une tâche qui la mesure</translation>
    </message>
    <message>
        <source>put it into %1</source>
        <translation>le mettre dans %1</translation>
    </message>
    <message>
        <source>put the file beside the task</source>
        <translation>mettre le fichier à côté de la tâche</translation>
    </message>
    <message>
        <source>raise it, or make the target longer</source>
        <translation>l’augmenter, ou allonger la cible</translation>
    </message>
    <message>
        <source>read what there is again</source>
        <translation>relire ce qui existe</translation>
    </message>
    <message>
        <source>reading a code</source>
        <translation>lecture d’un code</translation>
    </message>
    <message>
        <source>reading a consent</source>
        <translation>lecture d’un consentement</translation>
    </message>
    <message>
        <source>reading a profile</source>
        <translation>lecture d’un profil</translation>
    </message>
    <message>
        <source>reading accounts</source>
        <translation>lecture des comptes</translation>
    </message>
    <message>
        <source>reading an identity</source>
        <translation>lecture d’une identité</translation>
    </message>
    <message>
        <source>reading answers</source>
        <translation>lecture des réponses</translation>
    </message>
    <message>
        <source>reading clinical scores</source>
        <translation>lecture des scores cliniques</translation>
    </message>
    <message>
        <source>reading consents</source>
        <translation>lecture des consentements</translation>
    </message>
    <message>
        <source>reading erased codes</source>
        <translation>lecture des codes effacés</translation>
    </message>
    <message>
        <source>reading events</source>
        <translation>lecture des événements</translation>
    </message>
    <message>
        <source>reading identities</source>
        <translation>lecture des identités</translation>
    </message>
    <message>
        <source>reading instrument zeros</source>
        <translation>lecture des mises à zéro</translation>
    </message>
    <message>
        <source>reading measures</source>
        <translation>lecture des mesures</translation>
    </message>
    <message>
        <source>reading patients</source>
        <translation>lecture des patients</translation>
    </message>
    <message>
        <source>reading primary measures</source>
        <translation>lecture des mesures principales</translation>
    </message>
    <message>
        <source>reading progress</source>
        <translation>lecture de l’évolution</translation>
    </message>
    <message>
        <source>reading ratings</source>
        <translation>lecture des évaluations</translation>
    </message>
    <message>
        <source>reading resting forces</source>
        <translation>lecture des forces de repos</translation>
    </message>
    <message>
        <source>reading sessions</source>
        <translation>lecture des séances</translation>
    </message>
    <message>
        <source>reading stable times</source>
        <translation>lecture des périodes stables</translation>
    </message>
    <message>
        <source>reading the audit log</source>
        <translation>lecture du journal d’accès</translation>
    </message>
    <message>
        <source>reading the last instrument zero</source>
        <translation>lecture de la dernière mise à zéro</translation>
    </message>
    <message>
        <source>reading the newest sessions</source>
        <translation>lecture des dernières séances</translation>
    </message>
    <message>
        <source>reading the policy</source>
        <translation>lecture de la politique d’accès</translation>
    </message>
    <message>
        <source>reading treatment marks</source>
        <translation>lecture des traitements</translation>
    </message>
    <message>
        <source>reading trials</source>
        <translation>lecture des essais</translation>
    </message>
    <message>
        <source>reading values of other people</source>
        <translation>lecture des valeurs d’autres personnes</translation>
    </message>
    <message>
        <source>real time is required, but the system gives %1</source>
        <translation>le temps réel est exigé, mais le système donne %1</translation>
    </message>
    <message>
        <source>record it again, slower</source>
        <translation>l’enregistrer de nouveau, plus lentement</translation>
    </message>
    <message>
        <source>record one</source>
        <translation>en enregistrer un</translation>
    </message>
    <message>
        <source>record raw frames of a bus only</source>
        <translation>n’enregistrer des trames brutes que d’un bus</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>le retirer</translation>
    </message>
    <message>
        <source>remove it or correct its spelling</source>
        <translation>la retirer ou corriger son orthographe</translation>
    </message>
    <message>
        <source>remove one of them first</source>
        <translation>en retirer d’abord une</translation>
    </message>
    <message>
        <source>remove that one first, or give other days</source>
        <translation>retirer d’abord celle-là, ou indiquer d’autres jours</translation>
    </message>
    <message>
        <source>remove the limit, or align springs and dampers with the world</source>
        <translation>retirer la limite, ou aligner ressorts et amortisseurs sur le monde</translation>
    </message>
    <message>
        <source>remove the limit, or free one rotation only</source>
        <translation>retirer la limite, ou ne libérer qu’une rotation</translation>
    </message>
    <message>
        <source>removing a clinical score</source>
        <translation>retrait d’un score clinique</translation>
    </message>
    <message>
        <source>removing a primary measure</source>
        <translation>retrait d’une mesure principale</translation>
    </message>
    <message>
        <source>removing a stable time</source>
        <translation>retrait d’une période stable</translation>
    </message>
    <message>
        <source>removing a treatment mark</source>
        <translation>retrait d’un traitement</translation>
    </message>
    <message>
        <source>removing an account</source>
        <translation>retrait d’un compte</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>la renommer</translation>
    </message>
    <message>
        <source>rename that one, or take this one from %1</source>
        <translation>renommer celui-là, ou prendre celui-ci dans %1</translation>
    </message>
    <message>
        <source>resample the files to one time axis first</source>
        <translation>rééchantillonner d’abord les fichiers sur un même axe de temps</translation>
    </message>
    <message>
        <source>researcher</source>
        <translation>chercheur</translation>
    </message>
    <message>
        <source>restore the last backup</source>
        <translation>restaurer la dernière sauvegarde</translation>
    </message>
    <message>
        <source>restore the last backup; other trials can still be read</source>
        <translation>restaurer la dernière sauvegarde&#xa0;; les autres essais restent lisibles</translation>
    </message>
    <message>
        <source>restricting records</source>
        <translation>restriction des données</translation>
    </message>
    <message>
        <source>rewriting the file</source>
        <translation>réécriture du fichier</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>root table</source>
        <translation>table principale</translation>
    </message>
    <message>
        <source>run isograsp db check</source>
        <translation>lancer isograsp db check</translation>
    </message>
    <message>
        <source>run isograsp db check, then restore the last backup</source>
        <translation>lancer isograsp db check, puis restaurer la dernière sauvegarde</translation>
    </message>
    <message>
        <source>run isograsp db migrate on it; a copy of the file as it is now is kept</source>
        <translation>lancer isograsp db migrate&#xa0;; une copie du fichier actuel est conservée</translation>
    </message>
    <message>
        <source>run: sudo ip link set %1 up type can bitrate 1000000 restart-ms 100</source>
        <translation>lancer&#xa0;: sudo ip link set %1 up type can bitrate 1000000 restart-ms 100</translation>
    </message>
    <message>
        <source>say completed or aborted</source>
        <translation>indiquer completed ou aborted</translation>
    </message>
    <message>
        <source>say what was asked</source>
        <translation>indiquer ce qui a été demandé</translation>
    </message>
    <message>
        <source>say what was asked about</source>
        <translation>indiquer sur quoi portait la question</translation>
    </message>
    <message>
        <source>say which clinician judged the person stable</source>
        <translation>indiquer quel clinicien a jugé la personne stable</translation>
    </message>
    <message>
        <source>say who chose the measure</source>
        <translation>indiquer qui a choisi la mesure</translation>
    </message>
    <message>
        <source>say with --config which three are under the fingers</source>
        <translation>indiquer avec --config lesquels trois sont sous les doigts</translation>
    </message>
    <message>
        <source>scale the target to 0 … 1</source>
        <translation>ramener la cible à 0 … 1</translation>
    </message>
    <message>
        <source>second %1 came instead of %2</source>
        <translation>la seconde %1 est venue au lieu de %2</translation>
    </message>
    <message>
        <source>second %1 holds %2 rows, more than one second</source>
        <translation>la seconde %1 contient %2 lignes, plus d’une seconde</translation>
    </message>
    <message>
        <source>see isograsp db users list</source>
        <translation>voir isograsp db users list</translation>
    </message>
    <message>
        <source>see: isograsp devices</source>
        <translation>voir&#xa0;: isograsp devices</translation>
    </message>
    <message>
        <source>sends at %1 Hz, not at %2</source>
        <translation>envoie à %1 Hz, pas à %2</translation>
    </message>
    <message>
        <source>serial lines</source>
        <translation>des lignes série</translation>
    </message>
    <message>
        <source>set it to 0, or free %1</source>
        <translation>le mettre à 0, ou libérer %1</translation>
    </message>
    <message>
        <source>set the tool transformation to zero on the box&apos;s page Configurations</source>
        <translation>mettre à zéro la transformation d’outil sur la page Configurations du boîtier</translation>
    </message>
    <message>
        <source>shifts or turns its forces before it sends them</source>
        <translation>décale ou tourne ses forces avant de les envoyer</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>le raccourcir</translation>
    </message>
    <message>
        <source>signal group &apos;%1&apos; has no columns or one without a name</source>
        <translation>le groupe de signaux «&#xa0;%1&#xa0;» n’a pas de colonnes ou en a une sans nom</translation>
    </message>
    <message>
        <source>sort the rows and remove repeats</source>
        <translation>trier les lignes et retirer les répétitions</translation>
    </message>
    <message>
        <source>sort the times</source>
        <translation>trier les temps</translation>
    </message>
    <message>
        <source>stable time</source>
        <translation>période stable</translation>
    </message>
    <message>
        <source>stands in a read-only folder</source>
        <translation>est dans un dossier en lecture seule</translation>
    </message>
    <message>
        <source>start from an attitude about the free axes, or free more rotations</source>
        <translation>partir d’une orientation autour des axes libres, ou libérer plus de rotations</translation>
    </message>
    <message>
        <source>start inside the limit, or widen it</source>
        <translation>commencer dans la limite, ou l’élargir</translation>
    </message>
    <message>
        <source>start it from a desktop, or run a session without windows: isograsp run</source>
        <translation>le lancer depuis un bureau, ou faire une séance sans fenêtre&#xa0;: isograsp run</translation>
    </message>
    <message>
        <source>starts outside the limit of %1</source>
        <translation>commence hors de la limite de %1</translation>
    </message>
    <message>
        <source>starts outside the limit of the rotation</source>
        <translation>commence hors de la limite de la rotation</translation>
    </message>
    <message>
        <source>storing a PIN</source>
        <translation>enregistrement d’un PIN</translation>
    </message>
    <message>
        <source>storing a clinical score</source>
        <translation>enregistrement d’un score clinique</translation>
    </message>
    <message>
        <source>storing a consent</source>
        <translation>enregistrement d’un consentement</translation>
    </message>
    <message>
        <source>storing a password</source>
        <translation>enregistrement d’un mot de passe</translation>
    </message>
    <message>
        <source>storing a primary measure</source>
        <translation>enregistrement d’une mesure principale</translation>
    </message>
    <message>
        <source>storing a profile</source>
        <translation>enregistrement d’un profil</translation>
    </message>
    <message>
        <source>storing a rating</source>
        <translation>enregistrement d’une évaluation</translation>
    </message>
    <message>
        <source>storing a recovery key</source>
        <translation>enregistrement d’une clé de secours</translation>
    </message>
    <message>
        <source>storing a resting force</source>
        <translation>enregistrement d’une force de repos</translation>
    </message>
    <message>
        <source>storing a second of signals</source>
        <translation>enregistrement d’une seconde de signaux</translation>
    </message>
    <message>
        <source>storing a stable time</source>
        <translation>enregistrement d’une période stable</translation>
    </message>
    <message>
        <source>storing a treatment mark</source>
        <translation>enregistrement d’un traitement</translation>
    </message>
    <message>
        <source>storing an event</source>
        <translation>enregistrement d’un événement</translation>
    </message>
    <message>
        <source>storing an identity</source>
        <translation>enregistrement d’une identité</translation>
    </message>
    <message>
        <source>storing an instrument zero</source>
        <translation>enregistrement d’une mise à zéro</translation>
    </message>
    <message>
        <source>storing answers</source>
        <translation>enregistrement des réponses</translation>
    </message>
    <message>
        <source>storing the passphrase</source>
        <translation>enregistrement de la phrase secrète</translation>
    </message>
    <message>
        <source>storing the policy</source>
        <translation>enregistrement de la politique d’accès</translation>
    </message>
    <message>
        <source>string</source>
        <translation>texte entre guillemets</translation>
    </message>
    <message>
        <source>subdevice %1</source>
        <translation>sous-périphérique %1</translation>
    </message>
    <message>
        <source>subdevice %1 is no JR3 sensor</source>
        <translation>le sous-périphérique %1 n’est pas un capteur JR3</translation>
    </message>
    <message>
        <source>table header</source>
        <translation>en-tête de table</translation>
    </message>
    <message>
        <source>tables with blank bare keys are explicitly prohibited</source>
        <translation>les tables sans nom sont interdites</translation>
    </message>
    <message>
        <source>take an older backup</source>
        <translation>prendre une sauvegarde plus ancienne</translation>
    </message>
    <message>
        <source>takes longer than two hours</source>
        <translation>dure plus de deux heures</translation>
    </message>
    <message>
        <source>text</source>
        <translation>du texte</translation>
    </message>
    <message>
        <source>text after the bytes of the datagram</source>
        <translation>du texte après les octets du datagramme</translation>
    </message>
    <message>
        <source>text after the frame that is not R or T</source>
        <translation>du texte après la trame qui n’est pas R ou T</translation>
    </message>
    <message>
        <source>the CAN interface cannot be opened: %1</source>
        <translation>l’interface CAN ne peut pas être ouverte&#xa0;: %1</translation>
    </message>
    <message>
        <source>the CAN interface is switched off</source>
        <translation>l’interface CAN est désactivée</translation>
    </message>
    <message>
        <source>the address of a sensor is missing</source>
        <translation>l’adresse d’un capteur manque</translation>
    </message>
    <message>
        <source>the backup is not sound: %1</source>
        <translation>la sauvegarde n’est pas saine&#xa0;: %1</translation>
    </message>
    <message>
        <source>the block is %1</source>
        <translation>le bloc est %1</translation>
    </message>
    <message>
        <source>the box of the %1 has the address &apos;%2&apos;, which is not in numbers</source>
        <translation>le boîtier du doigt (%1) a l’adresse «&#xa0;%2&#xa0;», qui n’est pas en chiffres</translation>
    </message>
    <message>
        <source>the box&apos;s page does not have this element</source>
        <translation>la page du boîtier n’a pas cet élément</translation>
    </message>
    <message>
        <source>the box&apos;s page has more than a short text here</source>
        <translation>la page du boîtier a ici plus qu’un texte court</translation>
    </message>
    <message>
        <source>the box&apos;s page has this element twice</source>
        <translation>la page du boîtier a cet élément deux fois</translation>
    </message>
    <message>
        <source>the bus failed while the sensors were started: %1</source>
        <translation>le bus est tombé en panne au démarrage des capteurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>the calibration was made with sensor %1, but this one is %2</source>
        <translation>l’étalonnage a été fait avec le capteur %1, mais celui-ci est %2</translation>
    </message>
    <message>
        <source>the card cannot be opened: %1</source>
        <translation>la carte ne peut pas être ouverte&#xa0;: %1</translation>
    </message>
    <message>
        <source>the card has no subdevice %1</source>
        <translation>la carte n’a pas de sous-périphérique %1</translation>
    </message>
    <message>
        <source>the column appears twice</source>
        <translation>la colonne apparaît deux fois</translation>
    </message>
    <message>
        <source>the column is missing</source>
        <translation>la colonne manque</translation>
    </message>
    <message>
        <source>the configuration is for %1</source>
        <translation>la configuration est pour %1</translation>
    </message>
    <message>
        <source>the copy could not be written</source>
        <translation>la copie n’a pas pu être écrite</translation>
    </message>
    <message>
        <source>the copy is not sound: %1</source>
        <translation>la copie n’est pas saine&#xa0;: %1</translation>
    </message>
    <message>
        <source>the cut-off is not below half the rate</source>
        <translation>la fréquence de coupure n’est pas sous la moitié de la cadence</translation>
    </message>
    <message>
        <source>the database cannot be set to durable writing</source>
        <translation>la base de données ne peut pas être réglée pour une écriture durable</translation>
    </message>
    <message>
        <source>the day of the last record of %1 cannot be read</source>
        <translation>le jour du dernier enregistrement de %1 ne peut pas être lu</translation>
    </message>
    <message>
        <source>the device answers with HTTP status %1</source>
        <translation>l’appareil répond avec le statut HTTP %1</translation>
    </message>
    <message>
        <source>the device cannot be asked: %1</source>
        <translation>l’appareil ne peut pas être interrogé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the device cannot be reached: %1</source>
        <translation>l’appareil est injoignable&#xa0;: %1</translation>
    </message>
    <message>
        <source>the device has no raw frames</source>
        <translation>l’appareil n’a pas de trames brutes</translation>
    </message>
    <message>
        <source>the device is set up for the %1 hand, the session for the %2</source>
        <translation>l’appareil est réglé pour la main %1, la séance pour la main %2</translation>
    </message>
    <message>
        <source>the device&apos;s answer cannot be read: %1</source>
        <translation>la réponse de l’appareil ne peut pas être lue&#xa0;: %1</translation>
    </message>
    <message>
        <source>the field is empty while others of this finger are not</source>
        <translation>le champ est vide alors que d’autres de ce doigt ne le sont pas</translation>
    </message>
    <message>
        <source>the file cannot be brought back: %1</source>
        <translation>le fichier ne peut pas être ramené&#xa0;: %1</translation>
    </message>
    <message>
        <source>the file cannot be put away: %1</source>
        <translation>le fichier ne peut pas être rangé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the finger has two sensors</source>
        <translation>le doigt a deux capteurs</translation>
    </message>
    <message>
        <source>the fixed load of %1 N is above half of today&apos;s maximum, or that was not measured</source>
        <translation>la charge fixe de %1 N dépasse la moitié du maximum du jour, ou celui-ci n’a pas été mesuré</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>le dossier ne peut pas être créé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the force changed by less than 0.5 N</source>
        <translation>la force a changé de moins de 0.5 N</translation>
    </message>
    <message>
        <source>the force turns with the object while springs or dampers stand at an angle to the world&apos;s axes</source>
        <translation>la force tourne avec l’objet alors que ressorts ou amortisseurs sont obliques aux axes du monde</translation>
    </message>
    <message>
        <source>the frame period is not positive</source>
        <translation>la période d’image n’est pas positive</translation>
    </message>
    <message>
        <source>the free rotations cannot reach this attitude</source>
        <translation>les rotations libres ne peuvent pas atteindre cette orientation</translation>
    </message>
    <message>
        <source>the groups of second %1 do not hold the same number of whole rows</source>
        <translation>les groupes de la seconde %1 ne contiennent pas le même nombre de lignes entières</translation>
    </message>
    <message>
        <source>the header has an empty column name</source>
        <translation>l’en-tête a un nom de colonne vide</translation>
    </message>
    <message>
        <source>the identity of %1 was changed or is damaged</source>
        <translation>l’identité de %1 a été modifiée ou est endommagée</translation>
    </message>
    <message>
        <source>the index finger&apos;s sensor (%1)</source>
        <translation>le capteur de l’index (%1)</translation>
    </message>
    <message>
        <source>the index&apos;s sensor</source>
        <translation>le capteur de l’index</translation>
    </message>
    <message>
        <source>the last session finished its protocol</source>
        <translation>la dernière séance a terminé son protocole</translation>
    </message>
    <message>
        <source>the last session of this hand began more than four hours ago</source>
        <translation>la dernière séance de cette main a commencé il y a plus de quatre heures</translation>
    </message>
    <message>
        <source>the last session of this hand followed the protocol &apos;%1&apos;, or another version of this one</source>
        <translation>la dernière séance de cette main suivait le protocole «&#xa0;%1&#xa0;», ou une autre version de celui-ci</translation>
    </message>
    <message>
        <source>the limit has no bound</source>
        <translation>la limite n’a pas de borne</translation>
    </message>
    <message>
        <source>the line does not begin with a time in parentheses</source>
        <translation>la ligne ne commence pas par un temps entre parenthèses</translation>
    </message>
    <message>
        <source>the line ends before the bytes of the datagram</source>
        <translation>la ligne se termine avant les octets du datagramme</translation>
    </message>
    <message>
        <source>the line ends before the frame</source>
        <translation>la ligne se termine avant la trame</translation>
    </message>
    <message>
        <source>the line ends before this column</source>
        <translation>la ligne se termine avant cette colonne</translation>
    </message>
    <message>
        <source>the line has more fields than the header</source>
        <translation>la ligne a plus de champs que l’en-tête</translation>
    </message>
    <message>
        <source>the middle finger&apos;s sensor (%1)</source>
        <translation>le capteur du majeur (%1)</translation>
    </message>
    <message>
        <source>the middle&apos;s sensor</source>
        <translation>le capteur du majeur</translation>
    </message>
    <message>
        <source>the movement lasted less than a second</source>
        <translation>le mouvement a duré moins d’une seconde</translation>
    </message>
    <message>
        <source>the name of a database may not hold a quotation mark</source>
        <translation>le nom d’une base de données ne peut pas contenir de guillemet</translation>
    </message>
    <message>
        <source>the network</source>
        <translation>le réseau</translation>
    </message>
    <message>
        <source>the new backup is made, but this old one cannot be removed</source>
        <translation>la nouvelle sauvegarde est faite, mais cette ancienne ne peut pas être retirée</translation>
    </message>
    <message>
        <source>the object moved by less than 5 mm and 5 degrees</source>
        <translation>l’objet a bougé de moins de 5 mm et 5 degrés</translation>
    </message>
    <message>
        <source>the object turned about more than one axis</source>
        <translation>l’objet a tourné autour de plus d’un axe</translation>
    </message>
    <message>
        <source>the parameter is given twice</source>
        <translation>le paramètre est indiqué deux fois</translation>
    </message>
    <message>
        <source>the points of %1 were not loaded</source>
        <translation>les points de %1 n’ont pas été chargés</translation>
    </message>
    <message>
        <source>the protocol is missing</source>
        <translation>le protocole manque</translation>
    </message>
    <message>
        <source>the records of %1 are not released for research</source>
        <translation>les données de %1 ne sont pas autorisées pour la recherche</translation>
    </message>
    <message>
        <source>the records of %1 are restricted until %2</source>
        <translation>les données de %1 sont restreintes jusqu’au %2</translation>
    </message>
    <message>
        <source>the records of %1 are restricted until %2: the person asked for erasure</source>
        <translation>les données de %1 sont restreintes jusqu’au %2&#xa0;: la personne a demandé l’effacement</translation>
    </message>
    <message>
        <source>the role %1 has no PIN</source>
        <translation>le rôle %1 n’a pas de PIN</translation>
    </message>
    <message>
        <source>the role %1 may not change records</source>
        <translation>le rôle %1 ne peut pas modifier les données</translation>
    </message>
    <message>
        <source>the role %1 may not do this</source>
        <translation>le rôle %1 n’a pas ce droit</translation>
    </message>
    <message>
        <source>the role %1 may not see who people are</source>
        <translation>le rôle %1 ne peut pas voir qui sont les personnes</translation>
    </message>
    <message>
        <source>the screening allows this hand comfortable force only</source>
        <translation>les questions préalables ne permettent à cette main que la force confortable</translation>
    </message>
    <message>
        <source>the screening allows this hand no effort</source>
        <translation>les questions préalables ne permettent à cette main aucun effort</translation>
    </message>
    <message>
        <source>the sensor has no such filter</source>
        <translation>le capteur n’a pas ce filtre</translation>
    </message>
    <message>
        <source>the sensors have no such rate</source>
        <translation>les capteurs n’ont pas cette cadence</translation>
    </message>
    <message>
        <source>the sensors have no such speed</source>
        <translation>les capteurs n’ont pas cette vitesse</translation>
    </message>
    <message>
        <source>the serial port cannot be opened: %1</source>
        <translation>le port série ne peut pas être ouvert&#xa0;: %1</translation>
    </message>
    <message>
        <source>the session does not answer</source>
        <translation>la séance ne répond pas</translation>
    </message>
    <message>
        <source>the signals are not those that were recorded (content hash)</source>
        <translation>les signaux ne sont pas ceux enregistrés (empreinte du contenu)</translation>
    </message>
    <message>
        <source>the signals cannot be packed without loss</source>
        <translation>les signaux ne peuvent pas être compressés sans perte</translation>
    </message>
    <message>
        <source>the target is a share of the %1 of &apos;%2&apos; that no earlier step measures</source>
        <translation>la cible est une part de «&#xa0;%2&#xa0;» (%1) qu’aucune étape antérieure ne mesure</translation>
    </message>
    <message>
        <source>the target is a share of the %1 of &apos;%2&apos;, and no trial of this session measured one</source>
        <translation>la cible est une part de «&#xa0;%2&#xa0;» (%1), et aucun essai de cette séance ne l’a mesurée</translation>
    </message>
    <message>
        <source>the target of %1 has a band of +-%2, which the sensors cannot resolve</source>
        <translation>la cible de %1 a une bande de +-%2 que les capteurs ne peuvent pas résoudre</translation>
    </message>
    <message>
        <source>the target of %1 is above the ceiling of %2 for this hand</source>
        <translation>la cible de %1 dépasse le plafond de %2 pour cette main</translation>
    </message>
    <message>
        <source>the thumb&apos;s sensor</source>
        <translation>le capteur du pouce</translation>
    </message>
    <message>
        <source>the thumb&apos;s sensor (%1)</source>
        <translation>le capteur du pouce (%1)</translation>
    </message>
    <message>
        <source>the time cannot be stretched by %1</source>
        <translation>le temps ne peut pas être étiré de %1</translation>
    </message>
    <message>
        <source>the time is empty</source>
        <translation>le temps est vide</translation>
    </message>
    <message>
        <source>the times of the samples do not increase</source>
        <translation>les temps des échantillons n’augmentent pas</translation>
    </message>
    <message>
        <source>the trial has no samples</source>
        <translation>l’essai n’a pas d’échantillons</translation>
    </message>
    <message>
        <source>the trial has no signals</source>
        <translation>l’essai n’a pas de signaux</translation>
    </message>
    <message>
        <source>therapist</source>
        <translation>thérapeute</translation>
    </message>
    <message>
        <source>there are %1 primary measures already</source>
        <translation>il y a déjà %1 mesures principales</translation>
    </message>
    <message>
        <source>there is no %1 &apos;%2&apos;</source>
        <translation>il n’y a pas&#xa0;: %1 «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>there is no file of this name</source>
        <translation>il n’y a pas de fichier de ce nom</translation>
    </message>
    <message>
        <source>there is no patient &quot;%1&quot; in this database</source>
        <translation>il n’y a pas de patient «&#xa0;%1&#xa0;» dans cette base de données</translation>
    </message>
    <message>
        <source>there is no patient %1</source>
        <translation>il n’y a pas de patient %1</translation>
    </message>
    <message>
        <source>there is no patient &apos;%1&apos;</source>
        <translation>il n’y a pas de patient «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>there is no sensor for the %1</source>
        <translation>il n’y a pas de capteur pour&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no session %1</source>
        <translation>il n’y a pas de séance %1</translation>
    </message>
    <message>
        <source>there is no such CAN interface</source>
        <translation>il n’y a pas d’interface CAN de ce nom</translation>
    </message>
    <message>
        <source>there is no way to this address: %1</source>
        <translation>il n’y a pas de chemin vers cette adresse&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is nothing to resume: %1</source>
        <translation>il n’y a rien à reprendre&#xa0;: %1</translation>
    </message>
    <message>
        <source>this adaptor tells no serial number: nothing could be compared</source>
        <translation>cet adaptateur n’indique pas de numéro de série&#xa0;: rien à comparer</translation>
    </message>
    <message>
        <source>this hand has had no session yet</source>
        <translation>cette main n’a pas encore eu de séance</translation>
    </message>
    <message>
        <source>this is no XML: %1</source>
        <translation>ce n’est pas du XML&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is no address in numbers with a port</source>
        <translation>ce n’est pas une adresse en chiffres avec port</translation>
    </message>
    <message>
        <source>this is no page of a Net F/T box: it has not one root element</source>
        <translation>ce n’est pas une page d’un boîtier Net F/T&#xa0;: elle n’a pas un seul élément racine</translation>
    </message>
    <message>
        <source>this is no page of a Net F/T box: it is too large</source>
        <translation>ce n’est pas une page d’un boîtier Net F/T&#xa0;: elle est trop grande</translation>
    </message>
    <message>
        <source>this library has none</source>
        <translation>ces modèles n’en ont aucun</translation>
    </message>
    <message>
        <source>this program was built without libcomedi</source>
        <translation>ce programme a été compilé sans libcomedi</translation>
    </message>
    <message>
        <source>thumb</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>time</source>
        <translation>heure</translation>
    </message>
    <message>
        <source>time does not increase</source>
        <translation>le temps n’augmente pas</translation>
    </message>
    <message>
        <source>too many wrong passwords</source>
        <translation>trop de mots de passe erronés</translation>
    </message>
    <message>
        <source>treatment mark</source>
        <translation>traitement</translation>
    </message>
    <message>
        <source>trial %1 has not ended or does not exist</source>
        <translation>l’essai %1 n’est pas terminé ou n’existe pas</translation>
    </message>
    <message>
        <source>trial %1 is not being recorded</source>
        <translation>l’essai %1 n’est pas en cours d’enregistrement</translation>
    </message>
    <message>
        <source>trial %1 of session %2%3: %4</source>
        <translation>essai %1 de la séance %2%3&#xa0;: %4</translation>
    </message>
    <message>
        <source>trials were recorded with this version</source>
        <translation>des essais ont été enregistrés avec cette version</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>réessayer</translation>
    </message>
    <message>
        <source>try again; %1 left</source>
        <translation>réessayer&#xa0;; encore %1</translation>
    </message>
    <message>
        <source>turn the platform and choose the configuration for that hand, or choose the %1 hand</source>
        <translation>tourner la plateforme et choisir la configuration de cette main, ou choisir la main %1</translation>
    </message>
    <message>
        <source>turns about more than one axis</source>
        <translation>tourne autour de plus d’un axe</translation>
    </message>
    <message>
        <source>two free rotations are not a rotation group: what the locked one means would depend on the order of turning</source>
        <translation>deux rotations libres ne forment pas un groupe&#xa0;: le sens de la rotation bloquée dépendrait de l’ordre</translation>
    </message>
    <message>
        <source>two sensors have this address</source>
        <translation>deux capteurs ont cette adresse</translation>
    </message>
    <message>
        <source>two sensors have this serial port</source>
        <translation>deux capteurs ont ce port série</translation>
    </message>
    <message>
        <source>two sensors share an identifier or address</source>
        <translation>deux capteurs partagent un identifiant ou une adresse</translation>
    </message>
    <message>
        <source>underscores may only follow digits</source>
        <translation>les tirets bas ne peuvent suivre que des chiffres</translation>
    </message>
    <message>
        <source>underscores must be followed by digits</source>
        <translation>les tirets bas doivent être suivis de chiffres</translation>
    </message>
    <message>
        <source>unexpected control character</source>
        <translation>caractère de commande inattendu</translation>
    </message>
    <message>
        <source>unknown column of a finger</source>
        <translation>colonne inconnue d’un doigt</translation>
    </message>
    <message>
        <source>unknown escape sequence &apos;%1&apos;</source>
        <translation>séquence inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>clé inconnue</translation>
    </message>
    <message>
        <source>unknown parameter of %1://</source>
        <translation>paramètre inconnu de %1://</translation>
    </message>
    <message>
        <source>use %1</source>
        <translation>utiliser %1</translation>
    </message>
    <message>
        <source>use 10 to 1000</source>
        <translation>utiliser 10 à 1000</translation>
    </message>
    <message>
        <source>use 10, 20, 50, 100, 200, 333, 500 or 1000</source>
        <translation>utiliser 10, 20, 50, 100, 200, 333, 500 ou 1000</translation>
    </message>
    <message>
        <source>use 57600, 115200, 230400, 460800 or 921600</source>
        <translation>utiliser 57600, 115200, 230400, 460800 ou 921600</translation>
    </message>
    <message>
        <source>use a generated code of letters, digits and &apos;-&apos;, such as P-0427</source>
        <translation>utiliser un code généré de lettres, chiffres et «&#xa0;-&#xa0;», comme P-0427</translation>
    </message>
    <message>
        <source>use a rate that the box has: a whole fraction of 7000 Hz</source>
        <translation>utiliser une cadence du boîtier&#xa0;: une fraction entière de 7000 Hz</translation>
    </message>
    <message>
        <source>use one of those present: %1</source>
        <translation>utiliser l’une des présentes&#xa0;: %1</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>utiliser l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>use rft, ati-netcanoem, jr3-can or net-ft</source>
        <translation>utiliser rft, ati-netcanoem, jr3-can ou net-ft</translation>
    </message>
    <message>
        <source>use sim://healthy, replay://FILE.csv, can://, udp://, serial:// or comedi:// (see: isograsp devices)</source>
        <translation>utiliser sim://healthy, replay://FICHIER.csv, can://, udp://, serial:// ou comedi:// (voir&#xa0;: isograsp devices)</translation>
    </message>
    <message>
        <source>use the calibration of this sensor</source>
        <translation>utiliser l’étalonnage de ce capteur</translation>
    </message>
    <message>
        <source>use the comfortable-force task, and targets in newtons or of comfortable force</source>
        <translation>utiliser la tâche de force confortable, et des cibles en newtons ou en part de la force confortable</translation>
    </message>
    <message>
        <source>use the program that made it</source>
        <translation>utiliser le programme qui l’a créée</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>value or closing &apos;]&apos;</source>
        <translation>valeur ou «&#xa0;]&#xa0;»</translation>
    </message>
    <message>
        <source>value-terminator</source>
        <translation>fin de la valeur</translation>
    </message>
    <message>
        <source>values may not begin with underscores</source>
        <translation>les valeurs ne peuvent pas commencer par un tiret bas</translation>
    </message>
    <message>
        <source>wait %1 s, then try again</source>
        <translation>attendre %1 s, puis réessayer</translation>
    </message>
    <message>
        <source>was made by a newer isograsp (format %1, this program knows %2)</source>
        <translation>a été créée par un isograsp plus récent (format %1, ce programme connaît %2)</translation>
    </message>
    <message>
        <source>was made by an older isograsp (format %1, this program writes %2)</source>
        <translation>a été créée par un isograsp plus ancien (format %1, ce programme écrit %2)</translation>
    </message>
    <message>
        <source>whoever opened the database has fewer rights than this account</source>
        <translation>qui a ouvert la base de données a moins de droits que ce compte</translation>
    </message>
    <message>
        <source>write %1 numbers in brackets</source>
        <translation>écrire %1 nombres entre crochets</translation>
    </message>
    <message>
        <source>write %25 for a percent sign</source>
        <translation>écrire %25 pour un signe pour cent</translation>
    </message>
    <message>
        <source>write &apos;@isograsp - rtprio 50&apos; and &apos;@isograsp - memlock unlimited&apos; to /etc/security/limits.d/isograsp.conf, join that group and log in again (check: ulimit -r, ulimit -l), or use --realtime=prefer</source>
        <translation>écrire «&#xa0;@isograsp - rtprio 50&#xa0;» et «&#xa0;@isograsp - memlock unlimited&#xa0;» dans /etc/security/limits.d/isograsp.conf, rejoindre ce groupe et se reconnecter (vérifier&#xa0;: ulimit -r, ulimit -l), ou utiliser --realtime=prefer</translation>
    </message>
    <message>
        <source>write +x, -x, … -z</source>
        <translation>écrire +x, -x, … -z</translation>
    </message>
    <message>
        <source>write 0 or more</source>
        <translation>écrire 0 ou plus</translation>
    </message>
    <message>
        <source>write a direction across the normal</source>
        <translation>écrire une direction en travers de la normale</translation>
    </message>
    <message>
        <source>write a larger number</source>
        <translation>écrire un nombre plus grand</translation>
    </message>
    <message>
        <source>write a later day</source>
        <translation>écrire un jour ultérieur</translation>
    </message>
    <message>
        <source>write a longer time</source>
        <translation>écrire un temps plus long</translation>
    </message>
    <message>
        <source>write a name, for people</source>
        <translation>écrire un nom, pour des personnes</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>écrire un nombre</translation>
    </message>
    <message>
        <source>write a number above 0</source>
        <translation>écrire un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>write a number from %1 to %2</source>
        <translation>écrire un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>write a number that is not negative</source>
        <translation>écrire un nombre non négatif</translation>
    </message>
    <message>
        <source>write a number with &apos;.&apos; as the decimal sign, or leave the field empty if the value is missing</source>
        <translation>écrire un nombre avec «&#xa0;.&#xa0;» comme signe décimal, ou laisser le champ vide si la valeur manque</translation>
    </message>
    <message>
        <source>write a recovery or a factor</source>
        <translation>écrire une récupération ou un facteur</translation>
    </message>
    <message>
        <source>write a smaller factor</source>
        <translation>écrire un facteur plus petit</translation>
    </message>
    <message>
        <source>write a table</source>
        <translation>écrire une table</translation>
    </message>
    <message>
        <source>write a unit quaternion w, x, y, z</source>
        <translation>écrire un quaternion unitaire w, x, y, z</translation>
    </message>
    <message>
        <source>write a value from %1 to %2</source>
        <translation>écrire une valeur de %1 à %2</translation>
    </message>
    <message>
        <source>write a whole number</source>
        <translation>écrire un nombre entier</translation>
    </message>
    <message>
        <source>write a whole number from 0 to 100</source>
        <translation>écrire un nombre entier de 0 à 100</translation>
    </message>
    <message>
        <source>write a whole number from 1 to %1</source>
        <translation>écrire un nombre entier de 1 à %1</translation>
    </message>
    <message>
        <source>write a whole number such as day=14</source>
        <translation>écrire un nombre entier comme day=14</translation>
    </message>
    <message>
        <source>write a whole number such as seed=7</source>
        <translation>écrire un nombre entier comme seed=7</translation>
    </message>
    <message>
        <source>write an angle such as 1e-9</source>
        <translation>écrire un angle comme 1e-9</translation>
    </message>
    <message>
        <source>write another level</source>
        <translation>écrire un autre niveau</translation>
    </message>
    <message>
        <source>write at most %1</source>
        <translation>écrire au plus %1</translation>
    </message>
    <message>
        <source>write both bounds in one entry</source>
        <translation>écrire les deux bornes dans une seule entrée</translation>
    </message>
    <message>
        <source>write can://can0?protocol=rft</source>
        <translation>écrire can://can0?protocol=rft</translation>
    </message>
    <message>
        <source>write e.g. [0, 0, 1]</source>
        <translation>écrire p. ex. [0, 0, 1]</translation>
    </message>
    <message>
        <source>write each as [[%1%2]]</source>
        <translation>écrire chacune comme [[%1%2]]</translation>
    </message>
    <message>
        <source>write each entry in double quotes</source>
        <translation>écrire chaque entrée entre guillemets doubles</translation>
    </message>
    <message>
        <source>write for example day=0</source>
        <translation>écrire par exemple day=0</translation>
    </message>
    <message>
        <source>write frequencies up to 5 Hz</source>
        <translation>écrire des fréquences jusqu’à 5 Hz</translation>
    </message>
    <message>
        <source>write grip, grip_mean, pinch, sum, thumb, index, middle, opening, index_opening or e.g. thumb_-x</source>
        <translation>écrire grip, grip_mean, pinch, sum, thumb, index, middle, opening, index_opening ou p. ex. thumb_-x</translation>
    </message>
    <message>
        <source>write hand=right or hand=left</source>
        <translation>écrire hand=right ou hand=left</translation>
    </message>
    <message>
        <source>write how many rows before the end it begins and ends, e.g. [200, 50]</source>
        <translation>écrire combien de lignes avant la fin elle commence et finit, p. ex. [200, 50]</translation>
    </message>
    <message>
        <source>write how many units one step is</source>
        <translation>écrire combien d’unités vaut un pas</translation>
    </message>
    <message>
        <source>write it as 192.168.1.1</source>
        <translation>l’écrire comme 192.168.1.1</translation>
    </message>
    <message>
        <source>write it as 192.168.1.1:49152</source>
        <translation>l’écrire comme 192.168.1.1:49152</translation>
    </message>
    <message>
        <source>write it as [%1%2]</source>
        <translation>l’écrire comme [%1%2]</translation>
    </message>
    <message>
        <source>write it in double quotes</source>
        <translation>l’écrire entre guillemets doubles</translation>
    </message>
    <message>
        <source>write it to a file first and name that</source>
        <translation>écrivez-le d’abord dans un fichier et nommez celui-ci</translation>
    </message>
    <message>
        <source>write its points into [axis.csv_data], or choose another shape</source>
        <translation>écrire ses points dans [axis.csv_data], ou choisir une autre forme</translation>
    </message>
    <message>
        <source>write lines as (1700000000.001000) 192.168.1.1:49152 00000001 with the bytes in hexadecimal</source>
        <translation>écrire des lignes comme (1700000000.001000) 192.168.1.1:49152 00000001, les octets en hexadécimal</translation>
    </message>
    <message>
        <source>write lines as (1700000000.001000) can0 064#0C00000000000000</source>
        <translation>écrire des lignes comme (1700000000.001000) can0 064#0C00000000000000</translation>
    </message>
    <message>
        <source>write numbers</source>
        <translation>écrire des nombres</translation>
    </message>
    <message>
        <source>write numbers up to %1</source>
        <translation>écrire des nombres jusqu’à %1</translation>
    </message>
    <message>
        <source>write one [[axis]] per degree of freedom</source>
        <translation>écrire un [[axis]] par degré de liberté</translation>
    </message>
    <message>
        <source>write one of: %1</source>
        <translation>écrire l’un de&#xa0;: %1</translation>
    </message>
    <message>
        <source>write one value per time</source>
        <translation>écrire une valeur par temps</translation>
    </message>
    <message>
        <source>write rate_Hz = 100, or time_column = &quot;t&quot; and time_unit = &quot;s&quot;</source>
        <translation>écrire rate_Hz = 100, ou time_column = &quot;t&quot; et time_unit = &quot;s&quot;</translation>
    </message>
    <message>
        <source>write replay://FILE.csv</source>
        <translation>écrire replay://FICHIER.csv</translation>
    </message>
    <message>
        <source>write rows per second, e.g. 120</source>
        <translation>écrire des lignes par seconde, p. ex. 120</translation>
    </message>
    <message>
        <source>write scheme://target?key=value&amp;key=value</source>
        <translation>écrire scheme://target?key=value&amp;key=value</translation>
    </message>
    <message>
        <source>write sim://healthy or sim://paretic</source>
        <translation>écrire sim://healthy ou sim://paretic</translation>
    </message>
    <message>
        <source>write some of: x, y, z, rx, ry, rz</source>
        <translation>écrire certains de&#xa0;: x, y, z, rx, ry, rz</translation>
    </message>
    <message>
        <source>write texts in brackets</source>
        <translation>écrire des textes entre crochets</translation>
    </message>
    <message>
        <source>write the column&apos;s name, with &apos;-&apos; before it to turn the sign</source>
        <translation>écrire le nom de la colonne, précédé de «&#xa0;-&#xa0;» pour changer le signe</translation>
    </message>
    <message>
        <source>write the direction into the object</source>
        <translation>écrire la direction vers l’intérieur de l’objet</translation>
    </message>
    <message>
        <source>write the file name without folder, e.g. &quot;grip_sine.toml&quot;</source>
        <translation>écrire le nom du fichier sans dossier, p. ex. &quot;grip_sine.toml&quot;</translation>
    </message>
    <message>
        <source>write the name of its file without folder and ending, e.g. &quot;planar_block&quot;</source>
        <translation>écrire le nom de son fichier sans dossier ni extension, p. ex. &quot;planar_block&quot;</translation>
    </message>
    <message>
        <source>write the secret as text</source>
        <translation>écrire le secret sous forme de texte</translation>
    </message>
    <message>
        <source>write the secret there</source>
        <translation>y écrire le secret</translation>
    </message>
    <message>
        <source>write thumb, index or middle</source>
        <translation>écrire thumb, index ou middle</translation>
    </message>
    <message>
        <source>write thumb, index, middle separated by commas, or give them in the configuration and write %1://?config=FILE</source>
        <translation>écrire thumb, index, middle séparés par des virgules, ou les indiquer dans la configuration et écrire %1://?config=FICHIER</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>écrire true ou false</translation>
    </message>
    <message>
        <source>write version = %1</source>
        <translation>écrire version = %1</translation>
    </message>
    <message>
        <source>writing the audit log</source>
        <translation>écriture du journal d’accès</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the name of another file</source>
        <translation>«&#xa0;%1&#xa0;» est le nom d’un autre fichier</translation>
    </message>
    <message>
        <source>No tasks in %1/tasks.</source>
        <translation>Aucune tâche dans %1/tasks.</translation>
    </message>
    <message>
        <source>control characters other than TAB (U+0009) are explicitly prohibited</source>
        <translation>caractères de commande interdits, sauf les tabulations</translation>
    </message>
    <message>
        <source>control characters other than TAB (U+0009) are explicitly prohibited in comments</source>
        <translation>caractères de commande interdits dans les commentaires, sauf les tabulations</translation>
    </message>
    <message>
        <source>there is no %1 number %2</source>
        <translation>il n’y a pas&#xa0;: %1 numéro %2</translation>
    </message>
    <message>
        <source>unescaped control characters other than TAB (U+0009) are explicitly prohibited</source>
        <translation>caractères de commande ou fin de ligne dans le texte&#xa0;; seules les tabulations sont permises</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1, memory locked</source>
        <translation>SCHED_FIFO %1, mémoire verrouillée</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1, memory not locked (%2)</source>
        <translation>SCHED_FIFO %1, mémoire non verrouillée (%2)</translation>
    </message>
    <message>
        <source>The clock of this computer is behind the newest session of this file (%1).</source>
        <translation>L’horloge de cet ordinateur retarde sur la dernière séance de ce fichier (%1).</translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation>non autorisé</translation>
    </message>
    <message>
        <source>ordinary scheduling (%1), memory locked</source>
        <translation>ordonnancement ordinaire (%1), mémoire verrouillée</translation>
    </message>
    <message>
        <source>ordinary scheduling (%1), memory not locked (%2)</source>
        <translation>ordonnancement ordinaire (%1), mémoire non verrouillée (%2)</translation>
    </message>
    <message>
        <source>set it in the box&apos;s web page, leave filter_Hz out</source>
        <translation>le régler sur la page web du boîtier et omettre filter_Hz</translation>
    </message>
    <message>
        <source>the limit memlock is not unlimited</source>
        <translation>la limite memlock n’est pas levée</translation>
    </message>
    <message>
        <source>this board has none: leave filter_Hz out and use fir_taps</source>
        <translation>cette carte n’en a pas&#xa0;: omettre filter_Hz et utiliser fir_taps</translation>
    </message>
    <message>
        <source>use 0 (none) to 655.35</source>
        <translation>utiliser 0 (aucun) à 655.35</translation>
    </message>
    <message>
        <source>use 0 (none), 500, 125, 31.25, 7.8125, 1.953125 or 0.48828125</source>
        <translation>utiliser 0 (aucun), 500, 125, 31.25, 7.8125, 1.953125 ou 0.48828125</translation>
    </message>
    <message>
        <source>use 0 (none), 500, 300, 200, 150, 100, 50, 40, 30, 20, 10, 5, 3, 2 or 1</source>
        <translation>utiliser 0 (aucun), 500, 300, 200, 150, 100, 50, 40, 30, 20, 10, 5, 3, 2 ou 1</translation>
    </message>
    <message>
        <source>%1 does not tell its rate</source>
        <translation>%1 n’indique pas sa cadence</translation>
    </message>
    <message>
        <source>%1 sends at %2 Hz, not at %3</source>
        <translation>%1 envoie à %2 Hz, pas à %3</translation>
    </message>
    <message>
        <source>%1 shifts or turns its forces before it sends them</source>
        <translation>%1 décale ou tourne ses forces avant de les envoyer</translation>
    </message>
    <message>
        <source>cannot be closed to other programs</source>
        <translation>ne peut pas être fermé aux autres programmes</translation>
    </message>
    <message>
        <source>close it, then do the same again</source>
        <translation>fermez-le, puis recommencez</translation>
    </message>
    <message>
        <source>close them, then protect it</source>
        <translation>fermez-les, puis protégez le fichier</translation>
    </message>
    <message>
        <source>closing the file to others</source>
        <translation>fermeture du fichier aux autres</translation>
    </message>
    <message>
        <source>end that session, then protect it</source>
        <translation>terminez cette séance, puis protégez le fichier</translation>
    </message>
    <message>
        <source>give a code that both have</source>
        <translation>donnez un code que les deux ont</translation>
    </message>
    <message>
        <source>patient %1 is not in both files</source>
        <translation>le patient %1 n’est pas dans les deux fichiers</translation>
    </message>
    <message>
        <source>protect it: isograsp db protect FILE</source>
        <translation>protégez-la&#xa0;: isograsp db protect FICHIER</translation>
    </message>
    <message>
        <source>reading an erased code</source>
        <translation>lecture d’un code effacé</translation>
    </message>
    <message>
        <source>reading the last record</source>
        <translation>lecture du dernier enregistrement</translation>
    </message>
    <message>
        <source>what was removed may still stand in the file and its log: another program reads them</source>
        <translation>ce qui a été retiré peut encore se trouver dans le fichier et son journal&#xa0;: un autre programme les lit</translation>
    </message>
    <message>
        <source>Grips that were not made</source>
        <translation>Prises non réalisées</translation>
    </message>
    <message>
        <source>no grip was made</source>
        <translation>aucune prise n’a été réalisée</translation>
    </message>
    <message>
        <source>no held target appeared outside its tolerance</source>
        <translation>aucune cible tenue n’est apparue hors de sa tolérance</translation>
    </message>
    <message>
        <source>no level transport reached its target</source>
        <translation>aucun transport droit n’a atteint sa cible</translation>
    </message>
    <message>
        <source>no reached target appeared outside its tolerance</source>
        <translation>aucune cible atteinte n’est apparue hors de sa tolérance</translation>
    </message>
    <message>
        <source>no row of a hold counts</source>
        <translation>aucune ligne d’un maintien ne compte</translation>
    </message>
    <message>
        <source>no target that asks for a hold was reached</source>
        <translation>aucune cible qui demande un maintien n’a été atteinte</translation>
    </message>
    <message>
        <source>no target was reached</source>
        <translation>aucune cible n’a été atteinte</translation>
    </message>
    <message>
        <source>the targets ask for no hold</source>
        <translation>les cibles ne demandent aucun maintien</translation>
    </message>
    <message>
        <source>the values are too large to compute with</source>
        <translation>les valeurs sont trop grandes pour calculer</translation>
    </message>
    <message>
        <source>the values are too small to compute with</source>
        <translation>les valeurs sont trop petites pour calculer</translation>
    </message>
    <message>
        <source> was deleted or moved away</source>
        <translation> a été supprimé ou déplacé</translation>
    </message>
    <message>
        <source> was replaced</source>
        <translation> a été remplacé</translation>
    </message>
    <message>
        <source>%1: %2 while it was open</source>
        <translation>%1&#xa0;: %2 pendant qu’il était ouvert</translation>
    </message>
    <message>
        <source>%1: the file has reached the size that this program may write (RLIMIT_FSIZE), or the disk is full</source>
        <translation>%1&#xa0;: le fichier a atteint la taille que ce programme peut écrire (RLIMIT_FSIZE), ou le disque est plein</translation>
    </message>
    <message>
        <source>; all of this session is in %1: isograsp db rescue %2 takes it in</source>
        <translation>&#xa0;; toute cette séance est dans %1&#xa0;: isograsp db rescue %2 la reprend</translation>
    </message>
    <message>
        <source>; an emergency file could not be made either: %1</source>
        <translation>&#xa0;; un fichier de secours n’a pas pu être créé non plus&#xa0;: %1</translation>
    </message>
    <message>
        <source>; this was the emergency file</source>
        <translation>&#xa0;; c’était le fichier de secours</translation>
    </message>
    <message>
        <source>check the disk, and restore the last backup</source>
        <translation>vérifiez le disque et restaurez la dernière sauvegarde</translation>
    </message>
    <message>
        <source>closing a trial: another program has closed or removed it</source>
        <translation>clôture d’un essai&#xa0;: un autre programme l’a clos ou retiré</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>il n’est pas là</translation>
    </message>
    <message>
        <source>it is there as &apos;%1&apos; with %2 samples instead of &apos;%3&apos; with %4</source>
        <translation>il est là comme &apos;%1&apos; avec %2 échantillons au lieu de &apos;%3&apos; avec %4</translation>
    </message>
    <message>
        <source>its measures are not those that were stored</source>
        <translation>ses mesures ne sont pas celles qui ont été enregistrées</translation>
    </message>
    <message>
        <source>its signals are not those that were stored</source>
        <translation>ses signaux ne sont pas ceux qui ont été enregistrés</translation>
    </message>
    <message>
        <source>leave the file -lock where it is while a program records</source>
        <translation>laissez le fichier -lock où il est pendant qu’un programme enregistre</translation>
    </message>
    <message>
        <source>let only one program record into a file</source>
        <translation>ne laissez qu’un programme enregistrer dans un fichier</translation>
    </message>
    <message>
        <source>making an emergency file</source>
        <translation>création d’un fichier de secours</translation>
    </message>
    <message>
        <source>put it back as it was, or restore the last backup</source>
        <translation>remettez-le comme il était, ou restaurez la dernière sauvegarde</translation>
    </message>
    <message>
        <source>raise that limit (ulimit -f unlimited), or free some space; everything confirmed before is stored</source>
        <translation>relevez cette limite (ulimit -f unlimited) ou libérez de la place&#xa0;; tout ce qui a été confirmé avant est enregistré</translation>
    </message>
    <message>
        <source>reading an emergency file</source>
        <translation>lecture d’un fichier de secours</translation>
    </message>
    <message>
        <source>reading back trial %1: %2</source>
        <translation>relecture de l’essai %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>reading who the database is</source>
        <translation>lecture de l’identité de la base de données</translation>
    </message>
    <message>
        <source>set the clock, or connect again if it is right</source>
        <translation>réglez l’horloge, ou reconnectez si elle est juste</translation>
    </message>
    <message>
        <source>set the clock, or say that it is right</source>
        <translation>réglez l’horloge, ou dites qu’elle est juste</translation>
    </message>
    <message>
        <source>the clock of this computer says %1, but the newest session of this file is of %2</source>
        <translation>l’horloge de cet ordinateur indique %1, mais la séance la plus récente de ce fichier est du %2</translation>
    </message>
    <message>
        <source>the differences are too large for a number of the computer</source>
        <translation>les différences sont trop grandes pour un nombre de l’ordinateur</translation>
    </message>
    <message>
        <source>the lock (-lock) beside the file was deleted or replaced while it was recorded into: other programs take the running trial for an interrupted one</source>
        <translation>le verrou (-lock) à côté du fichier a été supprimé ou remplacé pendant l’enregistrement&#xa0;: d’autres programmes prennent l’essai en cours pour un essai interrompu</translation>
    </message>
    <message>
        <source>since the zero was set a sensor started anew (%1)</source>
        <translation>un capteur a redémarré depuis la mise à zéro (%1)</translation>
    </message>
    <message>
        <source>take the hand out and set the zero again</source>
        <translation>retirez la main et refaites la mise à zéro</translation>
    </message>
    <message>
        <source>keeping results of a newer version</source>
        <translation>conservation de résultats d’une version plus récente</translation>
    </message>
    <message>
        <source>does not hold all of %1 after it was taken in</source>
        <translation>ne contient pas tout ce qui est dans %1 après son intégration</translation>
    </message>
    <message>
        <source>is not there, so nothing can be taken into it</source>
        <translation>n’est pas là, donc rien ne peut y être intégré</translation>
    </message>
    <message>
        <source>keep that file, run isograsp db check, and rescue again</source>
        <translation>garder ce fichier, lancer isograsp db check, puis récupérer de nouveau</translation>
    </message>
    <message>
        <source>put it back or restore the last backup, then rescue again</source>
        <translation>la remettre en place ou restaurer la dernière sauvegarde, puis récupérer de nouveau</translation>
    </message>
    <message>
        <source>set XDG_STATE_HOME to a folder that you may write to</source>
        <translation>donner à XDG_STATE_HOME un dossier où vous pouvez écrire</translation>
    </message>
    <message>
        <source>the copy %1 cannot be put back</source>
        <translation>la copie %1 ne peut pas être remise en place</translation>
    </message>
</context>
<context>
    <name>isograsp::gui::BackupWork</name>
    <message>
        <source>No backup could be made: %1</source>
        <translation>Aucune sauvegarde n’a pu être faite : %1</translation>
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
        <translation>Force et moment de chaque doigt dans ses axes de contact : z vers l’appui, après la mise à zéro ; part du frottement sur l’objet virtuel qui est utilisée (Tab, puis flèches)</translation>
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
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
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
        <source>Do not connect to this device (Alt+C)</source>
        <translation>Ne pas se connecter à cet appareil (Alt+X)</translation>
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
        <source>Begin the session: needs patient, hand, screening and device (Alt+C)</source>
        <translation>Commencer la séance&#xa0;: exige patient, main, questions préalables et appareil (Alt+C)</translation>
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
        <source>A device is chosen and connected on the page of the session, once patient and hand are known.</source>
        <translation>L’appareil se choisit et se connecte sur la page de la séance, une fois le patient et la main connus.</translation>
    </message>
    <message>
        <source>No device is connected.</source>
        <translation>Aucun appareil n’est connecté.</translation>
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
        <translation>Qui est ce code ; le journal dit qui a regardé (Alt+Y)</translation>
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
        <translation>Qui êtes-vous ?</translation>
    </message>
    <message>
        <source>Your account (Alt+W, then arrow keys)</source>
        <translation>Votre compte (Alt+Q, puis flèches)</translation>
    </message>
    <message>
        <source>&amp;Who are you?</source>
        <translation>&amp;Qui êtes-vous ?</translation>
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
        <source>x to the right, y up; arrows: fingers and where they press; outlines: targets in their order, dashed: where an object appears</source>
        <translation>x vers la droite, y vers le haut&#xa0;; flèches&#xa0;: doigts et où ils appuient&#xa0;; contours&#xa0;: cibles dans leur ordre, en pointillé&#xa0;: où un objet apparaît</translation>
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
        <translation>Zéro, à vide</translation>
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
        <source>Left hand</source>
        <translation>Main gauche</translation>
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
        <source>Right hand</source>
        <translation>Main droite</translation>
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
        <source>Yes, today the less affected hand</source>
        <translation>Oui, aujourd’hui la main la moins atteinte</translation>
    </message>
    <message>
        <source>The hand on the affected side is another one; this one is meant (Tab, then space)</source>
        <translation>La main du côté atteint est l’autre&#xa0;; c’est bien celle-ci (Tab, puis Espace)</translation>
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
    <name>isograsp::gui::RatingPanel</name>
    <message>
        <source>Kept: effort %1, pain %2. Another number corrects it.</source>
        <translation>Conservé&#xa0;: effort %1, douleur %2. Un autre nombre corrige.</translation>
    </message>
    <message>
        <source>The other number is missing: nothing is kept yet.</source>
        <translation>L’autre nombre manque&#xa0;: rien n’est encore conservé.</translation>
    </message>
    <message>
        <source>Correct: effort %1, pain %2</source>
        <translation>Corriger&#xa0;: effort %1, douleur %2</translation>
    </message>
    <message>
        <source>Shows the last answer again; another number corrects it, and what it was is kept (Tab, then space)</source>
        <translation>Montre de nouveau la dernière réponse&#xa0;; un autre nombre la corrige, et ce qu’elle était est conservé (Tab, puis espace)</translation>
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
        <translation>L’imprimante n’accepte rien : est-elle branchée, a-t-elle du papier ?</translation>
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
        <translation>&amp;Aidé</translation>
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
        <source>Measures of the running or the last trial (Alt+U)</source>
        <translation>Mesures de l’essai en cours ou du dernier (Alt+U)</translation>
    </message>
    <message>
        <source>Res&amp;ult</source>
        <translation>Rés&amp;ultat</translation>
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
</context>
<context>
    <name>isograsp::gui::ScoreRow</name>
    <message>
        <source>%1: %2 of 10</source>
        <translation>%1&#xa0;: %2 sur 10</translation>
    </message>
    <message>
        <source>%1: %2 of 10 (Tab, then arrow keys)</source>
        <translation>%1&#xa0;: %2 sur 10 (Tab, puis flèches)</translation>
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
        <translation>La tâche demande %1° par newton ; l’écran du patient peut montrer %2°, ce qui est enregistré. Des yeux plus proches ou une image plus grande montrent davantage.</translation>
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
        <translation>Qui travaille ici ; enregistré avec les séances, zéros et forces de repos. Dans une base protégée, c’est la personne connectée (Alt+U)</translation>
    </message>
    <message>
        <source>&amp;Operator</source>
        <translation>Opérate&amp;ur</translation>
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
        <source>Search a code</source>
        <translation>Chercher un code</translation>
    </message>
    <message>
        <source>Search patients</source>
        <translation>Chercher des patients</translation>
    </message>
    <message>
        <source>Type a part of the code (Ctrl+F)</source>
        <translation>Saisir une partie du code (Ctrl+F)</translation>
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
        <source>&amp;Begin session</source>
        <translation>&amp;Commencer la séance</translation>
    </message>
    <message>
        <source>Begin a session</source>
        <translation>Commencer une séance</translation>
    </message>
    <message>
        <source>With the chosen patient (Alt+B)</source>
        <translation>Avec le patient choisi (Alt+C)</translation>
    </message>
    <message>
        <source>Open pat&amp;ient</source>
        <translation>&amp;Ouvrir le patient</translation>
    </message>
    <message>
        <source>Open the patient</source>
        <translation>Ouvrir le patient</translation>
    </message>
    <message>
        <source>Sessions, measures and trials so far (Alt+I)</source>
        <translation>Séances, mesures et essais jusqu’ici (Alt+O)</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>Séances récentes</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocole</translation>
    </message>
    <message>
        <source>Enter opens the patient (Tab, arrow keys)</source>
        <translation>Entrée ouvre le patient (Tab, flèches)</translation>
    </message>
    <message>
        <source>No sessions yet.</source>
        <translation>Pas encore de séances.</translation>
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
        <source>No code contains this text.</source>
        <translation>Aucun code ne contient ce texte.</translation>
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
        <source>Tasks one by one</source>
        <translation>Tâches une par une</translation>
    </message>
    <message>
        <source>%1, simulated</source>
        <translation>%1, simulé</translation>
    </message>
    <message>
        <source>No session yet; added %1</source>
        <translation>Pas encore de séance ; ajouté le %1</translation>
    </message>
    <message>
        <source>Last session %1, %2</source>
        <translation>Dernière séance %1, %2</translation>
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
        <source>TODAY</source>
        <translation>AUJOURD’HUI</translation>
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
        <translation>Noms à côté des codes, jusqu’au verrouillage de la fenêtre ; le journal dit qui les a lus (Alt+N)</translation>
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
        <source>%1: the marks as written on them (Tab)</source>
        <translation>%1&#xa0;: les repères tels qu’inscrits (Tab)</translation>
    </message>
    <message>
        <source>%1 (Tab, then arrow keys)</source>
        <translation>%1 (Tab, puis flèches)</translation>
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
        <source>The state of the session and the sensible next step</source>
        <translation>L’état de la séance et l’étape suivante utile</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>Forces come from software or a file, not from a person at this device</source>
        <translation>Les forces viennent d’un logiciel ou d’un fichier, pas d’une personne sur cet appareil</translation>
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
        <source>No hand, nothing touches the supports?</source>
        <translation>Pas de main, rien ne touche les appuis&#xa0;?</translation>
    </message>
    <message>
        <source>Yes, empt&amp;y</source>
        <translation>Oui, &amp;vide</translation>
    </message>
    <message>
        <source>Yes, the device is empty</source>
        <translation>Oui, l’appareil est vide</translation>
    </message>
    <message>
        <source>Set the zero now (Alt+Y)</source>
        <translation>Mettre à zéro maintenant (Alt+V)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Non</translation>
    </message>
    <message>
        <source>No, not yet</source>
        <translation>Non, pas encore</translation>
    </message>
    <message>
        <source>Keep the present zero (Alt+N)</source>
        <translation>Garder le zéro actuel (Alt+N)</translation>
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
</context>
</TS>
