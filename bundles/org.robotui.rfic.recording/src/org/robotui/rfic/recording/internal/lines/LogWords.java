package org.robotui.rfic.recording.internal.lines;

import java.util.Arrays;
import java.util.List;
import org.robotui.geometry.RigidTransform;

/** The words of a line, taken one after another. */
final class LogWords {
  private final String[] words;
  private final int end;
  private int at;

  LogWords(String[] words, int from, int end) {
    this.words = words;
    this.at = from;
    this.end = end;
  }

  String text(String what) {
    if (at >= end) {
      throw new IllegalArgumentException("it ends before " + what);
    }
    return words[at++];
  }

  double number(String what) {
    double number = number(text(what), what);
    if (!Double.isFinite(number)) {
      throw new IllegalArgumentException(what + " is " + number);
    }
    return number;
  }

  static double number(String word, String what) {
    try {
      return Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(what + " is '" + cut(word) + "', which is no number", e);
    }
  }

  private static String cut(String word) {
    return word.length() > 40 ? word.substring(0, 40) + "..." : word;
  }

  /** Numbers after their count, which are as many as the line has, at most. */
  float[] counted(String what) {
    double count = number("the number of " + what);
    if (count < 0 || count > end - at || count != Math.rint(count)) {
      throw new IllegalArgumentException("it has " + count + " " + what + " where " + (end - at) + " words are left");
    }
    float[] numbers = new float[(int) count];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = (float) number(text(what), what);
    }
    return numbers;
  }

  /** Where something is in the plane: metres and radians. */
  RigidTransform pose(String what) {
    double x = number(what);
    double y = number(what);
    return RigidTransform.planar(x, y, number(what));
  }

  void skip(int count, String what) {
    for (int i = 0; i < count; i++) {
      text(what);
    }
  }

  /** What is left. */
  List<String> rest() {
    return Arrays.asList(words).subList(at, end);
  }

  int left() {
    return end - at;
  }
}
