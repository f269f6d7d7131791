package org.robotui.uic.sound.internal.tone;

import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.SourceDataLine;

/** Plays over an audio device of this computer, which is opened for each sound: others want it too. */
public final class LineSpeaker implements Speaker {
  private static final int BITS = 16;
  private static final int POLL_MILLIS = 10;
  private static final double PATIENCE_SECONDS = 2;

  private final Lines lines;

  /** Over the device that the system prefers. */
  public LineSpeaker() {
    this(AudioSystem::getSourceDataLine);
  }

  LineSpeaker(Lines lines) {
    this.lines = lines;
  }

  @Override
  public void play(Pcm sound, double volume) throws SilentException, InterruptedException {
    AudioFormat format = new AudioFormat(sound.rate(), BITS, 1, true, false);
    try (SourceDataLine line = lines.line(format)) {
      line.open(format);
      line.start();
      write(line, sound.bytes(volume));
      await(line, sound);
    } catch (LineUnavailableException | IllegalArgumentException | SecurityException e) {
      throw new SilentException("no audio device takes " + sound.rate() + " Hz (" + e.getMessage()
          + "); connect one, or let this user use it", e);
    }
  }

  /** In pieces of a tenth of a second, so that the end of the view does not wait for the end of the sound. */
  private static void write(SourceDataLine line, byte[] bytes) throws InterruptedException {
    int piece = (int) line.getFormat().getFrameRate() / 10 * line.getFormat().getFrameSize();
    for (int at = 0; at < bytes.length; at += piece) {
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      line.write(bytes, at, Math.min(piece, bytes.length - at));
    }
  }

  /** The line's own way to wait cannot be interrupted, and hangs with a device that was unplugged. */
  private static void await(SourceDataLine line, Pcm sound) throws InterruptedException {
    long end = System.nanoTime() + (long) ((sound.seconds() + PATIENCE_SECONDS) * 1e9);
    while (line.getLongFramePosition() < sound.samples().length && System.nanoTime() < end) {
      Thread.sleep(POLL_MILLIS);
    }
  }

  /** Gives lines to audio devices. */
  interface Lines {
    SourceDataLine line(AudioFormat format) throws LineUnavailableException;
  }
}
