package org.robotui.sim.internal.ros2;

import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.robotui.message.ActionSchema;
import org.robotui.message.DynamicMessage;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeName;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionServer;
import org.robotui.ros2.action.Ros2GoalWorker;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.message.Places;
import org.robotui.sim.internal.message.RobotClock;

/** Serves the action {@code navigate_to_pose} as Nav2 does; a newer goal takes the place of an older one. */
final class NavigateServer implements Ros2GoalWorker, AutoCloseable {
  private static final TypeName TYPE = TypeName.parse("nav2_msgs/action/NavigateToPose").orElseThrow();
  private static final long PATIENCE_MILLIS = 200;

  private final Simulation simulation;
  private final Places places;
  private final RobotClock clock;
  private final Consumer<Event> events;
  private final Ros2ActionServer server;
  private final AtomicLong numbers = new AtomicLong();
  private boolean closed;

  NavigateServer(Ros2Node node, Simulation simulation, Places places, RobotClock clock, Consumer<Event> events,
      ThreadFactory threads) {
    this.simulation = simulation;
    this.places = places;
    this.clock = clock;
    this.events = events;
    server = Ros2ActionServer.open(node, "navigate_to_pose", type(node), threads, this);
  }

  private static TypedAction type(Ros2Node node) {
    return switch (node.context().types().registry().action(TYPE, Optional.empty())) {
      case SchemaLookup.Found<ActionSchema> found -> new TypedAction(TYPE, found.schema());
      case SchemaLookup.Missing<ActionSchema> missing -> throw new IllegalStateException(missing.reason());
    };
  }

  /** Drives to a place, without anybody who follows. */
  void drive(PoseStamped target) {
    Places.Found place = places.inMap(target.header().frameId(), target.pose());
    place.pose().ifPresentOrElse(pose -> {
      if (!simulation.submit(new Command.Goal(name(), pose))) {
        refused(NavigateMessages.BUSY);
      }
    }, () -> refused(place.problem()));
  }

  private String name() {
    return "navigate-" + numbers.incrementAndGet();
  }

  private void refused(String problem) {
    events.accept(new Event(Event.Severity.WARN, "commands", "goal refused: " + problem));
  }

  private Places.Found place(DynamicMessage goal) {
    return places.inMap(goal.text("pose.header.frame_id").orElse(""), NavigateMessages.pose(goal));
  }

  @Override
  public boolean accept(DynamicMessage goal) {
    Places.Found place = place(goal);
    if (place.pose().isEmpty()) {
      refused(place.problem());
    }
    return place.pose().isPresent();
  }

  @Override
  public End work(DynamicMessage goal, Running running) throws InterruptedException {
    Places.Found place = place(goal);
    if (place.pose().isEmpty()) {
      return NavigateMessages.aborted(place.problem());
    }
    NavigateGoal driven = new NavigateGoal(name(), place.pose().get(), running, clock);
    if (!simulation.submit(driven.command(), driven::begun)) {
      return NavigateMessages.aborted(NavigateMessages.BUSY);
    }
    while (true) {
      RobotState state = awaitSteps();
      Optional<End> end = driven.follow(state, simulation::submit);
      if (end.isPresent()) {
        return end.get();
      }
    }
  }

  private synchronized RobotState awaitSteps() throws InterruptedException {
    if (closed) {
      throw new InterruptedException("the simulation ends");
    }
    wait(PATIENCE_MILLIS);
    return simulation.state();
  }

  /** Lets goals see how far the robot got. */
  synchronized void step(long step) {
    if (Rate.GOALS.isDue(step)) {
      notifyAll();
    }
  }

  @Override
  public void close() {
    server.close();
    synchronized (this) {
      closed = true;
      notifyAll();
    }
  }
}
