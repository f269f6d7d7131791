package org.robotui.rfic.carmen.internal.feed;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Offer;
import org.robotui.api.session.BaseDriving;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.rfic.carmen.internal.convert.CarmenPlaces;

/** What the robot can be told, as soon as a program takes it. */
public final class Commanding implements AutoCloseable {
  private static final String VELOCITY = "carmen_robot_vel";
  private static final String GOAL = "carmen_navigator_set_goal_triplet";
  private static final String GO = "carmen_navigator_go";
  private static final String HALT = "carmen_navigator_stop";
  private static final String INITIALISE = "carmen_localize_initialize";
  private static final String TRUE_POSE = "carmen_simulator_set_truepose";

  private final Shared shared;
  private final Feeds feeds;
  private final Telling telling;
  private final Set<String> offered = new HashSet<>(); // only on the thread that follows
  private final List<Offer> offers = new ArrayList<>(); // guarded by this
  private final BaseDriving driving;
  private volatile boolean closed;

  public Commanding(Shared shared, Feeds feeds) {
    this.shared = shared;
    this.feeds = feeds;
    this.telling = new Telling(shared);
    this.driving = new BaseDriving(shared.settings().peer(), shared.pulse(), new Driven());
  }

  /** Offers what can be told now; blocks. */
  public void look() throws IOException {
    offer(VELOCITY, "velocity", VelocityCommand.class, "velocity of the base", driving, List.of(VELOCITY));
    offer(GOAL, "goal", NavigationGoal.class, "where the robot shall go, on the map", this::go, List.of(GOAL, GO));
    offer(INITIALISE, "initial_pose", PoseEstimate.class, "where the robot is, on the map", this::place,
        List.of(INITIALISE));
    offer(TRUE_POSE, "true_pose", PoseEstimate.class, "puts the simulated robot somewhere on the map", this::put,
        List.of(TRUE_POSE));
    if (feeds.isHandled(HALT)) {
      telling.prepare(HALT);
    }
  }

  private <C extends Data> void offer(String handled, String port, Class<C> type, String help, CommandSink<C> sink,
      List<String> messages) throws IOException {
    if (!feeds.isHandled(handled)) {
      return;
    }
    for (String message : messages) {
      telling.prepare(message);
    }
    synchronized (this) {
      if (!closed && offered.add(port)) {
        offers.add(shared.context().offers().command(new CommandPort<>(port, type, Arity.MANY, help), sink));
      }
    }
  }

  /** What nobody handles is lost without a word: that is said here. */
  private Sent told(String message, boolean sent) {
    if (!sent) {
      return new Sent.Refused(shared.settings().peer() + " cannot be reached");
    }
    return feeds.isHandled(message) ? new Sent.Out()
        : new Sent.Refused("no program takes " + message + " any more; start it again");
  }

  private Sent go(NavigationGoal goal) {
    if (!goal.frame().equals(shared.frames().map())) {
      return elsewhere("goals", goal.frame().name());
    }
    return told(GOAL, telling.tell(GOAL, telling.make(GOAL).struct("goal", CarmenPlaces.planar(goal.pose())).build())
        && telling.tell(GO, telling.make(GO).build()));
  }

  private Sent place(PoseEstimate pose) {
    if (!pose.frame().equals(shared.frames().map())) {
      return elsewhere("poses", pose.frame().name());
    }
    return told(INITIALISE,
        telling.tell(INITIALISE, CarmenPlaces.initialise(shared.forms().get(INITIALISE), pose, shared.now(),
            shared.module().name())));
  }

  private Sent put(PoseEstimate pose) {
    if (!pose.frame().equals(shared.frames().map())) {
      return elsewhere("poses", pose.frame().name());
    }
    return told(TRUE_POSE, telling.tell(TRUE_POSE,
        telling.make(TRUE_POSE).struct("pose", CarmenPlaces.planar(pose.pose())).build()));
  }

  private Sent elsewhere(String what, String frame) {
    String map = shared.frames().map().name();
    return new Sent.Refused("CARMEN takes " + what + " on " + map + ", not on " + frame
        + "; use a view that is fixed to " + map);
  }

  /** Drives the base. A navigator is told to stop with it. */
  private final class Driven implements BaseDriving.Base {
    @Override
    public Sent drive(VelocityCommand command) {
      return told(VELOCITY, telling.tell(VELOCITY, telling.make(VELOCITY).number("tv", command.linear().x())
          .number("rv", command.angular().z()).build()));
    }

    @Override
    public Sent halt(VelocityCommand zero) {
      boolean halted = !telling.isReady(HALT) || telling.tell(HALT, telling.make(HALT).build());
      Sent sent = drive(zero);
      return halted ? sent : told(HALT, false);
    }
  }

  @Override
  public synchronized void close() {
    driving.close();
    closed = true;
    offers.forEach(Offer::close);
  }
}
