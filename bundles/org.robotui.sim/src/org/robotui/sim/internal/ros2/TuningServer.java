package org.robotui.sim.internal.ros2;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterServer;
import org.robotui.ros2.parameter.Ros2ParameterValue;
import org.robotui.ros2.parameter.Ros2ParameterValue.OfBool;
import org.robotui.ros2.parameter.Ros2ParameterValue.OfDouble;
import org.robotui.ros2.parameter.Ros2ParameterValue.OfInteger;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.Tuning;
import org.robotui.sim.internal.Tuning.Style;
import org.robotui.sim.internal.message.DriveLimit;

/** Lets others change limits and habits while the robot runs, by parameters of its node. */
final class TuningServer implements AutoCloseable {
  private final Simulation simulation;
  private final Consumer<Event> events;
  private final Ros2ParameterServer server;

  TuningServer(Ros2Node node, Simulation simulation, Consumer<Event> events) {
    this.simulation = simulation;
    this.events = events;
    server = Ros2ParameterServer.open(node);
    Tuning tuning = simulation.state().tuning();
    DriveLimit.ALL.forEach(limit -> declare(limit, limit.of(tuning.limits())));
    Style[] styles = Style.values();
    OfInteger style = new OfInteger(tuning.style().ordinal());
    declare(Ros2ParameterDescriptor.of(DriveLimit.STYLE, style, DriveLimit.STYLE_DESCRIPTION + ": " + words(styles))
        .within(new Ros2ParameterDescriptor.IntegerRange(0, styles.length - 1, 1)), style);
    OfBool walks = new OfBool(tuning.personWalks());
    declare(Ros2ParameterDescriptor.of(DriveLimit.WALKS, walks, DriveLimit.WALKS_DESCRIPTION), walks);
    server.onSet(this::tune);
  }

  private void declare(DriveLimit limit, double now) {
    OfDouble value = new OfDouble(now);
    declare(Ros2ParameterDescriptor.of(limit.name(), value, limit.description())
        .within(new Ros2ParameterDescriptor.DoubleRange(limit.lowest(), limit.highest(), 0)), value);
  }

  private void declare(Ros2ParameterDescriptor descriptor, Ros2ParameterValue value) {
    server.declare(descriptor, value, any -> Optional.empty());
  }

  private static String words(Style[] styles) {
    return Arrays.stream(styles).map(style -> style.ordinal() + " " + style.description().toLowerCase(Locale.ROOT))
        .collect(Collectors.joining(", "));
  }

  private void tune(Map<String, Ros2ParameterValue> set) {
    Tuning now = simulation.state().tuning();
    Tuning wish = new Tuning(
        DriveLimit.limits(limit -> server.value(limit.name()) instanceof OfDouble real ? real.value()
            : limit.of(now.limits())),
        server.value(DriveLimit.STYLE) instanceof OfInteger whole ? Style.values()[(int) whole.value()] : now.style(),
        server.value(DriveLimit.WALKS) instanceof OfBool flag ? flag.value() : now.personWalks());
    if (!simulation.submit(new Command.Tune(wish))) {
      events.accept(new Event(Event.Severity.WARN, "commands", "too many commands at once: tuning was dropped"));
    }
  }

  @Override
  public void close() {
    server.close();
  }
}
