package org.robotui.rtps.internal.discovery;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.robotui.rtps.DataRepresentation;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Ownership;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reliability;
import org.robotui.rtps.internal.wire.WireException;

/** The numbers that stand for the words of QoS. */
final class WireQos {

  /** How long a reliable writer waits for room, as others say it; of no use to who hears it. */
  static final Duration BLOCKING = Duration.ofMillis(100);

  private static final int BEST_EFFORT = 1;

  private WireQos() {}

  /** What an endpoint has of which nothing is said: writers are reliable, readers are not. */
  static Qos standard(EndpointKind kind) {
    return kind == EndpointKind.WRITER ? Qos.reliable(1) : Qos.standard();
  }

  static int reliability(Reliability value) {
    return value == Reliability.BEST_EFFORT ? BEST_EFFORT : BEST_EFFORT + 1;
  }

  /** Some had 3 for reliable, once. */
  static Reliability reliability(int number) throws WireException {
    if (number < BEST_EFFORT || number > 3) {
      throw new WireException("a reliability of " + number);
    }
    return number == BEST_EFFORT ? Reliability.BEST_EFFORT : Reliability.RELIABLE;
  }

  static Durability durability(int number) throws WireException {
    return Durability.values()[index(number, Durability.values().length, "durability")];
  }

  static Liveliness liveliness(int number) throws WireException {
    return Liveliness.values()[index(number, Liveliness.values().length, "liveliness")];
  }

  static Ownership ownership(int number) throws WireException {
    return Ownership.values()[index(number, Ownership.values().length, "ownership")];
  }

  /** Numbers that are not known are left out; none at all stands for the first encoding. */
  static List<DataRepresentation> representations(List<Integer> numbers) {
    DataRepresentation[] known = DataRepresentation.values();
    List<DataRepresentation> list = new ArrayList<>();
    numbers.stream().filter(number -> number < known.length).forEach(number -> list.add(known[number]));
    return list.isEmpty() ? List.of(DataRepresentation.XCDR1) : list;
  }

  private static int index(int number, int count, String what) throws WireException {
    if (number < 0 || number >= count) {
      throw new WireException("a " + what + " of " + number);
    }
    return number;
  }
}
