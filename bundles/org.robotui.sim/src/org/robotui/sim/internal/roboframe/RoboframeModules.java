package org.robotui.sim.internal.roboframe;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.PoseStreamable;
import org.robotui.message.roboframe.TargetStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.roboframe.app.KeyInput;
import org.robotui.roboframe.app.ModuleChannels;
import org.robotui.roboframe.app.RoboModule;
import org.robotui.roboframe.app.RunPace;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** The modules of the robot's application that take something. */
final class RoboframeModules {
  private RoboframeModules() {}

  /** Drives as it is told, for half a second each time. */
  static final class Drive implements RoboModule {
    private final SimulatedRobot robot;
    private KeyInput<VelocityStreamable> velocity;

    Drive(SimulatedRobot robot) {
      this.robot = robot;
    }

    @Override
    public RunPace init(ModuleChannels channels) {
      velocity = channels.request(RoboframeKeys.VELOCITY);
      return new RunPace.OnChange();
    }

    @Override
    public void run() {
      velocity.take().ifPresent(posted -> {
        Speed speed = new Speed(posted.value().forward(), posted.value().turn());
        if (speed.isFinite()) {
          robot.simulation().submit(new Command.Drive(speed));
        }
      });
    }
  }

  /** Goes where it is told on the map. */
  static final class Navigation implements RoboModule {
    private final SimulatedRobot robot;
    private final AtomicLong goals = new AtomicLong();
    private KeyInput<TargetStreamable> target;

    Navigation(SimulatedRobot robot) {
      this.robot = robot;
    }

    @Override
    public RunPace init(ModuleChannels channels) {
      target = channels.request(RoboframeKeys.TARGET);
      return new RunPace.OnChange();
    }

    @Override
    public void run() {
      target.take().map(posted -> posted.value()).filter(Navigation::isFinite)
          .ifPresent(goal -> robot.simulation().submit(new Command.Goal("roboframe-" + goals.incrementAndGet(),
              new Pose2(goal.x(), goal.y(), goal.heading()))));
    }

    private static boolean isFinite(TargetStreamable goal) {
      return Double.isFinite(goal.x() + goal.y() + goal.heading());
    }
  }

  /** Believes in a ball in the middle of the room, and says where it is. */
  static final class Vision implements RoboModule {
    private static final double PER_METRE = 1000;
    private final LongSupplier clock;
    private final Pose2 ball;
    private final String name;
    private KeyInput<PoseStreamable> pose;
    private KeyOutput<DynamicMessage> model;

    Vision(String name, Pose2 ball, LongSupplier clock) {
      this.name = name;
      this.ball = ball;
      this.clock = clock;
    }

    @Override
    public RunPace init(ModuleChannels channels) {
      pose = channels.request(RoboframeKeys.POSE);
      model = channels.advertise(RoboframeKeys.BALL);
      return new RunPace.Cyclic(Duration.ofMillis(100));
    }

    @Override
    public void run() throws Exception {
      if (pose.newest().isPresent()) {
        PoseStreamable here = pose.newest().get().value();
        double distance = ball.distanceTo(new Pose2(here.x(), here.y(), 0));
        model.push(new DynamicCodec(RoboframeKeys.BALL_TYPE).build(Map.of("stamp", clock.getAsLong(), "x_mm",
            ball.x() * PER_METRE, "y_mm", ball.y() * PER_METRE, "distance_mm", distance * PER_METRE, "seen_by", name)));
      }
    }
  }

  /** Believes where a team mate is, who says it himself: nobody of this application writes what it reads. */
  static final class Team implements RoboModule {
    private static final double PER_METRE = 1000;
    private KeyInput<OdometryStreamable> mate;
    private KeyOutput<DynamicMessage> model;

    @Override
    public RunPace init(ModuleChannels channels) {
      mate = channels.request(RoboframeKeys.MATE);
      model = channels.advertise(RoboframeKeys.TEAM);
      return new RunPace.OnChange();
    }

    @Override
    public void run() throws Exception {
      if (mate.newest().isPresent()) {
        OdometryStreamable there = mate.newest().get().value();
        model.push(new DynamicCodec(RoboframeKeys.TEAM_TYPE)
            .build(Map.of("mate_x_mm", there.x() * PER_METRE, "mate_y_mm", there.y() * PER_METRE)));
      }
    }
  }
}
