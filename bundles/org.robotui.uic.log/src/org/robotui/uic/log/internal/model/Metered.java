package org.robotui.uic.log.internal.model;

/** A text that can be read only so often, so that no regular expression runs for ever on it. */
final class Metered implements CharSequence {
  private final String text;
  private final int[] left;

  Metered(String text, int reads) {
    this(text, new int[]{reads});
  }

  private Metered(String text, int[] left) {
    this.text = text;
    this.left = left;
  }

  @Override
  public char charAt(int index) {
    if (--left[0] < 0) {
      throw new TooSlowException();
    }
    return text.charAt(index);
  }

  @Override
  public int length() {
    return text.length();
  }

  @Override
  public CharSequence subSequence(int from, int to) {
    return new Metered(text.substring(from, to), left);
  }

  @Override
  public String toString() {
    return text;
  }
}
