package org.robotui.uic.sound.internal.tone;

/**
 * A sound, one channel.
 *
 * @param samples from −1 to 1; not to be changed
 * @param rate samples per second
 */
public record Pcm(float[] samples, int rate) {
  private static final int BYTES = 2;

  /** How long it sounds, seconds. */
  public double seconds() {
    return (double) samples.length / rate;
  }

  /** As signed 16-bit numbers, little endian, at a volume of 0 to 1. What is louder than full scale is clipped. */
  public byte[] bytes(double volume) {
    byte[] bytes = new byte[samples.length * BYTES];
    for (int i = 0; i < samples.length; i++) {
      int value = (int) Math.round(Math.clamp(samples[i] * volume, -1.0, 1.0) * Short.MAX_VALUE);
      bytes[BYTES * i] = (byte) value;
      bytes[BYTES * i + 1] = (byte) (value >> Byte.SIZE);
    }
    return bytes;
  }
}
