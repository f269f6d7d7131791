package org.robotui.uic.sound.internal.tone;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * Speaks by the first program that is installed: {@code spd-say} of speech-dispatcher, which the user has set up for
 * all programs, else {@code espeak-ng}.
 *
 * @param path the folders in which programs are looked for, as in the variable of that name
 */
public record ProgramVoice(String path) implements Voice {
  private static final List<List<String>> PROGRAMS =
      List.of(List.of("spd-say", "--wait", "--"), List.of("espeak-ng", "--"), List.of("espeak", "--"));
  private static final int MOST_CHARACTERS = 200;
  private static final long LONGEST_SECONDS = 20;

  @Override
  public void say(String words) throws SilentException, InterruptedException {
    List<String> command = new ArrayList<>(PROGRAMS.stream().flatMap(program -> installed(program).stream()).findFirst()
        .orElseThrow(() -> new SilentException(
            "alerts are not spoken, as neither spd-say nor espeak-ng is installed; install speech-dispatcher or espeak-ng")));
    command.add(words.substring(0, Math.min(words.length(), MOST_CHARACTERS)));
    try {
      await(
          new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start(),
          command.getFirst());
    } catch (IOException e) {
      throw new SilentException(
          "alerts are not spoken: " + command.getFirst() + " cannot be started: " + e.getMessage(),
          e);
    }
  }

  private Optional<List<String>> installed(List<String> program) {
    return Arrays.stream(path.split(":")).filter(folder -> folder.startsWith("/"))
        .map(folder -> Path.of(folder, program.getFirst())).filter(Files::isExecutable).findFirst()
        .map(file -> {
          List<String> command = new ArrayList<>(program);
          command.set(0, file.toString());
          return command;
        });
  }

  /** One that hangs must not keep the alerts behind it. */
  private static void await(Process process, String program) throws SilentException, InterruptedException {
    try {
      if (!process.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS)) {
        throw new SilentException(
            "alerts are not spoken: " + program + " did not end within " + LONGEST_SECONDS + " s");
      }
      if (process.exitValue() != 0) {
        throw new SilentException("alerts are not spoken: " + program + " ended with " + process.exitValue());
      }
    } finally {
      process.destroyForcibly();
    }
  }
}
