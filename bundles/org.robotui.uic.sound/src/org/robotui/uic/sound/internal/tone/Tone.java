package org.robotui.uic.sound.internal.tone;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The sounds that are made, not read. */
public enum Tone {
  /** Short and plain: worth a look. */
  BEEP(List.of(new Note(880, 0, 0.18, 0))),
  /** Two struck notes, downwards: something changed. */
  CHIME(List.of(new Note(1046.5, 0, 0.9, 5), new Note(784, 0.22, 1.1, 4))),
  /** Two pitches by turns, without end to their loudness: somebody must act. */
  ALARM(List.of(new Note(960, 0, 0.2, 0), new Note(770, 0.2, 0.2, 0), new Note(960, 0.4, 0.2, 0),
      new Note(770, 0.6, 0.2, 0),
      new Note(960, 0.8, 0.2, 0), new Note(770, 1.0, 0.2, 0)));

  /** Samples per second of all of them. */
  public static final int RATE = 44_100;

  private static final double PEAK = 0.6;

  /** A tone that begins or ends at once clicks. */
  private static final double RAMP_SECONDS = 0.006;

  /** How loud the overtones are, the first of them the tone itself. */
  private static final double[] OVERTONES = {0.8, 0.15, 0.05};

  private final List<Note> notes;

  Tone(List<Note> notes) {
    this.notes = notes;
  }

  /** The word in a configuration. */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Finds a sound by its word. */
  public static Optional<Tone> find(String id) {
    return Arrays.stream(values()).filter(tone -> tone.id().equals(id)).findFirst();
  }

  /** Makes the sound. */
  public Pcm sound() {
    double seconds = notes.stream().mapToDouble(note -> note.start() + note.seconds()).max().orElse(0);
    float[] samples = new float[(int) Math.ceil(seconds * RATE)];
    notes.forEach(note -> note.addTo(samples));
    return new Pcm(samples, RATE);
  }

  /**
   * A note.
   *
   * @param hertz its pitch
   * @param start when it begins, seconds
   * @param seconds how long it is
   * @param decay how fast it fades, per second; 0 for not at all
   */
  private record Note(double hertz, double start, double seconds, double decay) {
    void addTo(float[] samples) {
      int first = (int) Math.round(start * RATE);
      int count = Math.min((int) Math.round(seconds * RATE), samples.length - first);
      for (int i = 0; i < count; i++) {
        samples[first + i] += (float) (PEAK * level((double) i / RATE) * wave((double) i / RATE));
      }
    }

    private double level(double t) {
      double ramp = Math.min(1, Math.min(t, seconds - t) / RAMP_SECONDS);
      return ramp * Math.exp(-decay * t);
    }

    private double wave(double t) {
      double sum = 0;
      for (int i = 0; i < OVERTONES.length; i++) {
        sum += OVERTONES[i] * Math.sin(2 * Math.PI * hertz * (i + 1) * t);
      }
      return sum;
    }
  }
}
