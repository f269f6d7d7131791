package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Batteries and chargers. The interface {@code power}. */
public final class Power {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("power", "state", State.class);

  /** Request: charging by {@link Charging}; the answer is empty. */
  public static final Kind.Request<Charging, Empty> CHARGING =
      new Kind.Request<>("power", "charging", Charging.class, Empty.class);

  private Power() {}

  /**
   * How much energy there is.
   *
   * @param valid which fields are filled: 1 volts, 2 watts, 4 joules, 8 percent, 16 charging
   * @param volts the battery's voltage, volts
   * @param percent of a full charge, percent
   * @param joules stored energy, joules
   * @param watts negative while it is used up, watts
   * @param charging 1 is charged, -1 charges another, 0 neither
   */
  public record State(long valid, float volts, float percent, float joules, float watts, int charging) {}

  /**
   * What may flow.
   *
   * @param input whether it may be charged
   * @param output whether it may charge others
   */
  public record Charging(boolean input, boolean output) {}
}
