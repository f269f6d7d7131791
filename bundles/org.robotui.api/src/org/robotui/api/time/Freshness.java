package org.robotui.api.time;

import org.robotui.data.DataType;
import org.robotui.data.record.DynamicRecord;

/** The rule by which a value is too old while its source could send others. */
public final class Freshness {
  private static final double AT_LEAST_SECONDS = 1;
  private static final double PERIODS = 3;

  private Freshness() {}

  /**
   * Whether a value is too old. One that is kept for late comers holds until the next, unless they come as often as
   * measurements do. A record of which only one came may be an event as well as a measurement: it has no rhythm yet
   * that could be missed.
   *
   * @param type its type
   * @param kept whether its sender keeps it for late comers
   * @param ageSeconds how old it is
   * @param periodSeconds how far values of its source are apart, 0 where that is not known
   * @return true where a newer one should have come
   */
  public static boolean isStale(DataType type, boolean kept, double ageSeconds, double periodSeconds) {
    double limit = Math.max(AT_LEAST_SECONDS, PERIODS * periodSeconds);
    boolean event = type.type() == DynamicRecord.class && periodSeconds == 0;
    boolean holds = event || kept && (periodSeconds == 0 || periodSeconds >= AT_LEAST_SECONDS);
    return type.expires() && !holds && ageSeconds > limit;
  }
}
