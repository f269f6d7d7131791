package org.robotui.uic.plot.internal.signal;

/** First in, first out, without an object per sample. One thread. */
final class SampleQueue {
  private long[] times = new long[64];
  private double[] values = new double[64];
  private int head;
  private int size;

  int size() {
    return size;
  }

  boolean isEmpty() {
    return size == 0;
  }

  long time(int index) {
    return times[head + index & times.length - 1];
  }

  double value(int index) {
    return values[head + index & values.length - 1];
  }

  void add(long time, double value) {
    if (size == times.length) {
      grow();
    }
    int at = head + size & times.length - 1;
    times[at] = time;
    values[at] = value;
    size++;
  }

  void remove() {
    head = head + 1 & times.length - 1;
    size--;
  }

  void clear() {
    head = 0;
    size = 0;
  }

  private void grow() {
    long[] moreTimes = new long[2 * size];
    double[] moreValues = new double[2 * size];
    for (int i = 0; i < size; i++) {
      moreTimes[i] = time(i);
      moreValues[i] = value(i);
    }
    times = moreTimes;
    values = moreValues;
    head = 0;
  }
}
