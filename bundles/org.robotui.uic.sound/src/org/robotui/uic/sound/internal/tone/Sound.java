package org.robotui.uic.sound.internal.tone;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.config.Placed;

/** What an alert sounds like. */
public sealed interface Sound {
  /**
   * Makes or reads it. Blocks for files.
   *
   * @return the sound
   * @throws SilentException where a file cannot be read
   */
  Pcm load() throws SilentException;

  /**
   * Why it cannot be heard, as far as that can be told by the beginning of a file.
   *
   * @return what is wrong, behind the name of the file
   */
  default Optional<String> fault() {
    return Optional.empty();
  }

  /**
   * One that is made.
   *
   * @param tone which
   */
  record Made(Tone tone) implements Sound {
    @Override
    public Pcm load() {
      return tone.sound();
    }
  }

  /**
   * One from a file.
   *
   * @param path a WAV file
   */
  record File(Path path) implements Sound {
    @Override
    public Pcm load() throws SilentException {
      return WavFile.read(path);
    }

    @Override
    public Optional<String> fault() {
      return WavHead.fault(path);
    }
  }

  /**
   * Reads the word of a configuration; files are relative to it.
   *
   * @param written a word, or the path of a file
   * @return the sound
   * @throws IllegalArgumentException where it is neither; the message says what to write
   */
  static Sound parse(Placed written) {
    Sound sound = parse(written.value().toString());
    return sound instanceof File f ? new File(written.resolve(f.path().toString())) : sound;
  }

  /**
   * Reads the word of a configuration.
   *
   * @param text a word, or the path of a file
   * @return the sound
   * @throws IllegalArgumentException where it is neither; the message says what to write
   */
  static Sound parse(String text) {
    Optional<Tone> tone = Tone.find(text);
    if (tone.isPresent()) {
      return new Made(tone.get());
    }
    if (text.toLowerCase(Locale.ROOT).endsWith(".wav")) {
      return new File(Path.of(text));
    }
    String words = Arrays.stream(Tone.values()).map(Tone::id).collect(Collectors.joining(", "));
    throw new IllegalArgumentException(
        "there is no sound '" + text + "'; write one of " + words + ", or the path of a .wav file");
  }
}
