package org.robotui.sim.internal.message;

import java.util.function.Consumer;
import org.robotui.message.ros.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.message.ros.geometry_msgs.Twist;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.robot.Speed;

/** Turns what others publish into commands. */
final class Subscriptions {
  private final Simulation simulation;
  private final Places places;
  private final Consumer<Event> events;

  Subscriptions(MessageNode node, Simulation simulation, Places places, Consumer<Event> events) {
    this.simulation = simulation;
    this.places = places;
    this.events = events;
    node.listen("cmd_vel", Twist.class, this::drive);
    node.listen("initialpose", PoseWithCovarianceStamped.class, this::initialPose);
  }

  private void drive(Twist twist) {
    Speed speed = new Speed(twist.linear().x(), twist.angular().z());
    if (speed.isFinite()) {
      submit(new Command.Drive(speed));
    } else {
      warn("cmd_vel ignored: it is not finite");
    }
  }

  private void initialPose(PoseWithCovarianceStamped pose) {
    Places.Found place = places.inMap(pose.header().frameId(), pose.pose().pose());
    place.pose().ifPresentOrElse(
        found -> submit(new Command.InitialPose(found)), () -> warn("initialpose ignored: " + place.problem()));
  }

  private void submit(Command command) {
    if (!simulation.submit(command)) {
      warn("too many commands at once: one was dropped");
    }
  }

  private void warn(String text) {
    events.accept(new Event(Event.Severity.WARN, "commands", text));
  }
}
