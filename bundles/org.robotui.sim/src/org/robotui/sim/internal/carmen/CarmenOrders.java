package org.robotui.sim.internal.carmen;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.carmen.module.IpcAnswer;
import org.robotui.carmen.module.IpcModule;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/**
 * Turns what others send into commands, and answers what they ask. A goal is driven to when the robot is told to go.
 */
final class CarmenOrders {
  private static final int LATEST = 1;
  private static final int ALL = 100;
  /** How long a velocity holds, as CARMEN's motion timeout. */
  private static final double HOLD = 1;

  private final IpcModule module;
  private final IpcForms forms;
  private final SimulatedRobot robot;
  private final CarmenRecords records;
  private final AtomicReference<Optional<Pose2>> goal = new AtomicReference<>(Optional.empty());
  private final AtomicLong goals = new AtomicLong();

  CarmenOrders(IpcModule module, IpcForms forms, SimulatedRobot robot, CarmenRecords records) throws IOException {
    this.module = module;
    this.forms = forms;
    this.robot = robot;
    this.records = records;
    hear("carmen_robot_vel", this::drive);
    hear("carmen_navigator_set_goal_triplet", m -> aim(m.record("goal")));
    hear("carmen_navigator_set_goal", this::aim);
    hear("carmen_navigator_go", m -> go());
    hear("carmen_navigator_stop", m -> submit(new Command.Cancel("carmen-" + goals.get())));
    hear("carmen_localize_initialize", this::believe);
    answer("carmen_gridmap_request", m -> records.map());
    answer("carmen_localize_globalpos_query", m -> records.place(robot.state()));
    answer("carmen_navigator_status_query", m -> records.status(robot.state()));
    answer("carmen_navigator_plan_query", m -> records.plan(robot.state()));
  }

  private void hear(String message, Consumer<IpcRecord> action) throws IOException {
    module.subscribe(forms.get(message), LATEST, (record, body) -> {
      action.accept(record);
      return Optional.empty();
    });
  }

  private interface Answering {
    IpcRecordMaker to(IpcRecord question);
  }

  private void answer(String message, Answering answering) throws IOException {
    module.subscribe(forms.get(message), ALL, (record, body) -> {
      IpcRecordMaker made = answering.to(record);
      return Optional.of(new IpcAnswer(made.form(), made.build()));
    });
  }

  private void drive(IpcRecord message) {
    Speed speed = new Speed(message.number("tv"), message.number("rv"));
    if (speed.isFinite()) {
      submit(new Command.Drive(speed, HOLD));
    }
  }

  private void aim(IpcRecord message) {
    double turned = message.field("theta").isPresent() ? message.number("theta") : robot.state().estimate().yaw();
    Pose2 there = records.fromMap(message.number("x"), message.number("y"), turned);
    goal.set(Double.isFinite(there.x() + there.y() + there.yaw()) ? Optional.of(there) : Optional.empty());
  }

  private void go() {
    goal.get().ifPresent(there -> submit(new Command.Goal("carmen-" + goals.incrementAndGet(), there)));
  }

  private void believe(IpcRecord message) {
    message.records("mean").stream().findFirst().map(m -> records.fromMap(m.number("x"), m.number("y"),
        m.number("theta"))).filter(p -> Double.isFinite(p.x() + p.y() + p.yaw()))
        .ifPresent(pose -> submit(new Command.InitialPose(pose)));
  }

  private void submit(Command command) {
    robot.simulation().submit(command);
  }
}
