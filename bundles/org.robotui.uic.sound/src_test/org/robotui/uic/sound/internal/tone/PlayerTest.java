package org.robotui.uic.sound.internal.tone;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.RejectedExecutionException;
import org.junit.jupiter.api.Test;

class PlayerTest {
  private static final Sound BEEP = new Sound.Made(Tone.BEEP);

  private final Deque<Runnable> tasks = new ArrayDeque<>();
  private final List<String> heard = new ArrayList<>();
  private final List<String> trouble = new ArrayList<>();

  @Test
  void soundsAreHeardOneAfterTheOtherAndNotOnTheCallersThread() {
    Player player = player((sound, volume) -> heard.add(sound.samples().length + " at " + volume));
    player.play("a", BEEP, 0.5, "");
    player.play("b", new Sound.Made(Tone.CHIME), 1, "");
    assertTrue(heard.isEmpty());
    assertEquals(1, tasks.size());
    runAll();
    assertEquals(
        List.of(Tone.BEEP.sound().samples().length + " at 0.5", Tone.CHIME.sound().samples().length + " at 1.0"),
        heard);
    player.play("a", BEEP, 1, "");
    runAll();
    assertEquals(3, heard.size());
  }

  @Test
  void whatWaitsIsNotPlayedTwiceAndNotManyWait() {
    Player player = player((sound, volume) -> heard.add("sound"));
    for (int i = 0; i < 20; i++) {
      player.play("same", BEEP, 1, "");
    }
    runAll();
    assertEquals(1, heard.size());
    for (int i = 0; i < 20; i++) {
      player.play("alert " + i, BEEP, 1, "");
    }
    runAll();
    assertEquals(5, heard.size());
  }

  @Test
  void withoutADeviceTheBellRingsAndTheReasonIsSaidOnce() {
    Player player = player((sound, volume) -> {
      throw new SilentException("no audio device", null);
    });
    for (int i = 0; i < 3; i++) {
      player.play("a", BEEP, 1, "");
      runAll();
    }
    assertEquals(List.of("no audio device"), trouble);
    assertEquals(List.of("bell", "bell", "bell"), heard);
  }

  @Test
  void aJavaWithoutSoundIsTold() {
    Player player = new Player(tasks::add, () -> {
      throw new NoClassDefFoundError("javax/sound/sampled/AudioFormat");
    }, heard::add, () -> heard.add("bell"), trouble::add);
    player.play("a", BEEP, 1, "");
    runAll();
    assertEquals(List.of("this Java has no sound (java.desktop is missing); use one that has it"), trouble);
    assertEquals(List.of("bell"), heard);
  }

  @Test
  void inPlaceOfAMissingFileABeepIsHeard() {
    Player player = player((sound, volume) -> heard.add("" + sound.samples().length));
    player.play("a", new Sound.File(Path.of("/nowhere/horn.wav")), 1, "");
    runAll();
    assertEquals(List.of("" + Tone.BEEP.sound().samples().length), heard);
    assertTrue(trouble.getFirst().startsWith("cannot read the sound /nowhere/horn.wav"), trouble.toString());
  }

  @Test
  void theEndOfTheViewEndsAllThatWaits() {
    Player player = player((sound, volume) -> {
      throw new InterruptedException();
    });
    player.play("a", BEEP, 1, "");
    player.play("b", BEEP, 1, "");
    runAll();
    assertTrue(Thread.interrupted());
    assertTrue(heard.isEmpty());
    new Player(task -> {
      throw new RejectedExecutionException();
    }, () -> (sound, volume) -> heard.add("sound"), heard::add, () -> heard.add("bell"), trouble::add).play("c", BEEP,
        1, "");
    assertTrue(heard.isEmpty());
  }

  @Test
  void wordsAreSpokenAfterTheSoundAlsoWhereThatIsNotHeard() {
    Player player = player((sound, volume) -> heard.add("sound"));
    player.play("a", BEEP, 1, "Keira: Battery low");
    runAll();
    assertEquals(List.of("sound", "Keira: Battery low"), heard);
    Player mute = player((sound, volume) -> {
      throw new SilentException("no audio device");
    });
    mute.play("a", BEEP, 1, "Keira: Battery low");
    runAll();
    assertEquals(List.of("sound", "Keira: Battery low", "bell", "Keira: Battery low"), heard);
  }

  @Test
  void whyNothingIsSpokenIsSaidOnce() {
    Player player = new Player(tasks::add, () -> (sound, volume) -> heard.add("sound"), words -> {
      throw new SilentException("no program speaks");
    }, () -> heard.add("bell"), trouble::add);
    for (int i = 0; i < 3; i++) {
      player.play("a", BEEP, 1, "low");
      runAll();
    }
    assertEquals(List.of("no program speaks"), trouble);
    assertEquals(List.of("sound", "sound", "sound"), heard);
  }

  private Player player(Speaker speaker) {
    return new Player(tasks::add, () -> speaker, heard::add, () -> heard.add("bell"), trouble::add);
  }

  private void runAll() {
    while (!tasks.isEmpty()) {
      tasks.poll().run();
    }
  }
}
