package org.robotui.uic.status.internal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.sensor.Battery;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;

/** Lines of batteries. */
final class BatteryRows {
  private static final double PERCENT = 100;

  private BatteryRows() {}

  /**
   * A line.
   *
   * @param source where it comes from
   * @param name how it is called
   * @param battery the newest value
   * @param state of the source
   * @param low the fraction below which the charge is a warning
   */
  static StatusRow of(SourceId source, String name, Optional<Battery> battery, InputState state, double low) {
    Health health = StateView.health(state);
    if (health == Health.OK) {
      health = battery.map(b -> health(b.charge(), low)).orElse(Health.WAITING);
    }
    String age = health == Health.STALE ? StateView.word(state) : "";
    List<String> texts = battery.map(b -> texts(b, age)).orElseGet(() -> List.of(StateView.word(state)));
    return new StatusRow.Charge("battery " + source, health, name, battery.map(Battery::charge).orElse(Double.NaN),
        texts,
        source + "\nBattery, charge in % of full, V, A (negative when discharging)\n" + texts.getFirst());
  }

  private static Health health(double charge, double low) {
    return charge < low / 2 ? Health.BAD : charge < low ? Health.WARNING : Health.OK;
  }

  private static List<String> texts(Battery battery, String age) {
    String charge = figure(battery.charge() * PERCENT, 0, "%");
    String voltage = figure(battery.voltage(), 1, "V");
    String current = figure(battery.current(), 1, "A");
    String status = status(battery.status());
    return Stream
        .of(line(age, charge, voltage, current, status), line(age, charge, voltage, status), line(age, charge, status),
            line(age, charge))
        .distinct().toList();
  }

  private static String line(String... parts) {
    return Stream.of(parts).filter(text -> !text.isEmpty()).collect(Collectors.joining("  "));
  }

  private static String figure(double value, int decimals, String unit) {
    return Double.isNaN(value) ? "" : Figures.of(value, decimals, unit);
  }

  private static String status(Battery.Status status) {
    return switch (status) {
      case UNKNOWN, DISCHARGING -> "";
      default -> status.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    };
  }
}
