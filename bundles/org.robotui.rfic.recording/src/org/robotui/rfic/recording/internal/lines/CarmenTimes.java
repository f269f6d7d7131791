package org.robotui.rfic.recording.internal.lines;

import java.util.stream.Stream;
import org.robotui.rfic.recording.internal.lines.LineChannels.Moment;

/**
 * The times of a log of CARMEN. A line ends with the time of its message, since 1970, the host, and the time at which
 * it was written, which is since 1970 or since the logger was started.
 *
 * @param began when the logger was started, in seconds since 1970, where times are counted from there
 */
record CarmenTimes(double began) {
  private static final int TAIL = 3;
  /** Earlier times are counted from the start of the logger. */
  private static final double EARLIEST = 1e8;
  private static final double LATEST = 9e9;
  private static final double MICROS = 1e6;
  private static final long MICRO = 1000;

  /** From the first line that has both times. */
  static CarmenTimes of(Stream<String> lines) {
    return lines.filter(line -> !line.startsWith("#")).map(line -> line.split("\\s+"))
        .filter(words -> words.length > TAIL).map(CarmenTimes::began).filter(time -> time > 0)
        .findFirst().map(CarmenTimes::new).orElse(new CarmenTimes(0));
  }

  private static double began(String[] words) {
    try {
      double stamp = Double.parseDouble(words[words.length - TAIL]);
      double written = Double.parseDouble(words[words.length - 1]);
      return stamp > EARLIEST && written < EARLIEST ? stamp - written : 0;
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  Moment of(String[] words) {
    double written = LogWords.number(words[words.length - 1], "the time at its end");
    double stamp = LogWords.number(words[words.length - TAIL], "the time of its message");
    double logged = written < EARLIEST ? began + written : written;
    if (!(logged >= 0 && logged < LATEST)) {
      throw new IllegalArgumentException("its time is " + written + " s");
    }
    return new Moment(nanos(logged), stamp >= 0 && stamp < LATEST ? nanos(stamp) : nanos(logged));
  }

  /** Of a line without a time of its own message. */
  Moment written(String[] words) {
    String[] last = {"0", "", words[words.length - 1]};
    Moment moment = of(last);
    return new Moment(moment.logged(), moment.logged());
  }

  /** Logs have microseconds. */
  private static long nanos(double seconds) {
    return Math.round(seconds * MICROS) * MICRO;
  }
}
