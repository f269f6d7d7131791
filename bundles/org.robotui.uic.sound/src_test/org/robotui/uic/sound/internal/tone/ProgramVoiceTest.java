package org.robotui.uic.sound.internal.tone;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProgramVoiceTest {
  @TempDir
  private Path folder;

  private void program(String name, String script) throws IOException {
    Path file = Files.writeString(folder.resolve(name), "#!/bin/sh\n" + script + "\n");
    assertTrue(file.toFile().setExecutable(true));
  }

  private void recording(String name) throws IOException {
    program(name, "for a in \"$@\"; do echo \"" + name + " $a\" >>'" + folder + "/said'; done");
  }

  private List<String> said() throws IOException {
    return Files.readAllLines(folder.resolve("said"));
  }

  private Voice voice() {
    return new ProgramVoice("relative:/nowhere:" + folder);
  }

  @Test
  void wordsAreOneArgumentAndNeverAnOption() throws Exception {
    recording("espeak-ng");
    voice().say("-f /etc/passwd; $(reboot)");
    assertEquals(List.of("espeak-ng --", "espeak-ng -f /etc/passwd; $(reboot)"), said());
  }

  @Test
  void whatTheUserHasSetUpForAllProgramsIsPreferred() throws Exception {
    recording("espeak-ng");
    recording("spd-say");
    voice().say("low ".repeat(500));
    assertEquals(List.of("spd-say --wait", "spd-say --"), said().subList(0, 2));
    assertEquals("spd-say ".length() + 200, said().get(2).length());
  }

  @Test
  void whereNothingCanSpeakThatIsSaid() throws IOException {
    assertTrue(assertThrows(SilentException.class, () -> voice().say("low")).getMessage().contains("install"));
    program("spd-say", "exit 3");
    assertTrue(assertThrows(SilentException.class, () -> voice().say("low")).getMessage().contains("ended with 3"));
  }

  @Test
  void theEndOfTheViewEndsTheSpeech() throws IOException {
    program("spd-say", "exec sleep 60");
    Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, () -> voice().say("low"));
  }
}
