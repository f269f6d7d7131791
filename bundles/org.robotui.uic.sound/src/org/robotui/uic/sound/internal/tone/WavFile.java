package org.robotui.uic.sound.internal.tone;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.ShortBuffer;
import java.nio.file.Path;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.UnsupportedAudioFileException;

/** Reads sounds from files. */
public final class WavFile {
  private static final int BITS = 16;
  private static final int LONGEST_SECONDS = 30;
  private static final int MOST_CHANNELS = 8;
  private static final float HIGHEST_RATE = 192_000;

  private WavFile() {}

  /**
   * Reads a file; of a long one the beginning.
   *
   * @param file a WAV file
   * @return its channels as one
   * @throws SilentException where it cannot be read
   */
  public static Pcm read(Path file) throws SilentException {
    try (AudioInputStream stream = AudioSystem.getAudioInputStream(file.toFile())) {
      AudioFormat own = stream.getFormat();
      if (own.getChannels() < 1 || own.getChannels() > MOST_CHANNELS
          || !(own.getSampleRate() > 0 && own.getSampleRate() <= HIGHEST_RATE)) {
        throw new UnsupportedAudioFileException(
            "it has " + own.getChannels() + " channels at " + own.getSampleRate() + " Hz");
      }
      AudioFormat wanted = new AudioFormat(own.getSampleRate(), BITS, own.getChannels(), true, false);
      try (AudioInputStream plain = AudioSystem.getAudioInputStream(wanted, stream)) {
        return mixed(plain, wanted);
      }
    } catch (IOException | UnsupportedAudioFileException | IllegalArgumentException e) {
      throw new SilentException(
          "cannot read the sound " + file + " (" + e.getMessage() + "); name a WAV file with PCM samples", e);
    }
  }

  private static Pcm mixed(InputStream plain, AudioFormat format) throws IOException {
    int rate = (int) format.getSampleRate();
    byte[] bytes = plain.readNBytes(LONGEST_SECONDS * rate * format.getFrameSize());
    ShortBuffer values = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer();
    float[] samples = new float[values.remaining() / format.getChannels()];
    for (int i = 0; i < samples.length; i++) {
      for (int channel = 0; channel < format.getChannels(); channel++) {
        samples[i] += values.get() / (float) (Short.MAX_VALUE * format.getChannels());
      }
    }
    return new Pcm(samples, rate);
  }
}
