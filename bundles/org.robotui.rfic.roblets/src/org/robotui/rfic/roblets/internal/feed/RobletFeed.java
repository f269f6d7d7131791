package org.robotui.rfic.roblets.internal.feed;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink.Sent;
import org.robotui.api.port.Offer;
import org.robotui.api.session.BaseDriving;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.data.RobletMessages;
import org.robotui.rfic.roblets.internal.convert.InputMeaning;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.wire.RobletForm;

/** One roblet as ports. Those of its first beacon stay; what later ones have more is added. */
final class RobletFeed implements AutoCloseable {
  private final RobletsShared shared;
  private final BodyFeeds feeds;
  private final String roblet;
  private final Map<String, OutputFeed<?>> outputs = new TreeMap<>(); // guarded by this, as the following
  private final Map<String, BaseDriving> drivings = new TreeMap<>();
  private final List<Offer> offers = new ArrayList<>();
  private String told = "";
  private boolean places;

  RobletFeed(RobletsShared shared, BodyFeeds feeds, String roblet) {
    this.shared = shared;
    this.feeds = feeds;
    this.roblet = roblet;
  }

  /** How many ports it has. */
  synchronized int offer(RobletForm form) {
    form.outputs().stream().filter(output -> !outputs.containsKey(output.name()))
        .forEach(output -> outputs.put(output.name(), made(output)));
    form.inputs().stream()
        .filter(input -> InputMeaning.isVelocity(input) && !drivings.containsKey(input.name())).forEach(this::drive);
    return outputs.size() + drivings.size();
  }

  private OutputFeed<?> made(BodyForm form) {
    RobotFrames frames = shared.frames();
    places |= form.as().equals("odometry") || form.as().equals("pose");
    return switch (form.as()) {
      case "gpsfix" -> feed(form, GpsFix.class, "where it is on earth", true,
          (m, at) -> RobletMessages.fix(m, frames.base()));
      case "heading" -> feed(form, Imu.class, "where its bow points", false,
          (m, at) -> RobletMessages.heading(m, frames.base()));
      case "pose" -> feed(form, PoseEstimate.class, "where it is on the map", true, this::located);
      case "odometry" -> feed(form, Odometry.class, "where it is since it began", false, this::moved);
      case "battery" -> feed(form, Battery.class, "what its battery holds", false,
          (m, at) -> RobletMessages.battery(m));
      default -> feed(form, DynamicRecord.class, "as the roblet says it", false, (m, at) -> m);
    };
  }

  private String port(BodyForm form) {
    return roblet + "/" + form.name();
  }

  private <D extends Data> OutputFeed<D> feed(BodyForm form, Class<D> type, String help, boolean placed,
      OutputFeed.Making<D> making) {
    return new OutputFeed<>(shared, new OutputFeed.Spoken(roblet, form), type, "roblet " + roblet + ": " + help, placed,
        making);
  }

  private Odometry moved(DynamicRecord said, Optional<Stamp> stamp) {
    Odometry moved = RobletMessages.odometry(said, shared.frames().odom(), shared.frames().base());
    feeds.moved(moved.pose());
    shared.tree().placed(moved.frame(), moved.childFrame(), moved.pose(), stamp);
    return moved;
  }

  private PoseEstimate located(DynamicRecord said, Optional<Stamp> stamp) {
    PoseEstimate place = RobletMessages.pose(said, shared.frames().map());
    RigidTransform base = feeds.moved();
    shared.tree().placed(shared.frames().map(), shared.frames().odom(), place.pose().times(base.inverse()), stamp);
    return place;
  }

  private void drive(BodyForm form) {
    BaseDriving driving = new BaseDriving(shared.settings().peer(), shared.pulse(),
        command -> send(form, command));
    drivings.put(form.name(), driving);
    offers.add(shared.context().offers().command(new CommandPort<>(port(form), VelocityCommand.class, Arity.MANY,
        "roblet " + roblet + ": drives the robot"), driving));
  }

  private Sent send(BodyForm form, VelocityCommand command) {
    boolean stops = command.equals(VelocityCommand.ZERO);
    Optional<String> refusal = stops ? Optional.empty() : feeds.refusal(roblet);
    if (refusal.isPresent()) {
      return new Sent.Refused(refusal.get());
    }
    return feeds.ask(roblet, InputMeaning.velocity(form.name(), command)) ? new Sent.Out()
        : new Sent.Refused(shared.settings().peer() + " cannot be reached");
  }

  /** Whether somebody wants to hear the roblet; those who know where it is, too, where others need to know. */
  synchronized boolean wanted(boolean carried) {
    return places && carried || outputs.values().stream().anyMatch(OutputFeed::wanted);
  }

  synchronized boolean placedAndWanted() {
    return outputs.values().stream().anyMatch(OutputFeed::placedAndWanted);
  }

  void said(BodyEntry entry, byte[] bytes) {
    Optional<OutputFeed<?>> feed;
    synchronized (this) {
      feed = Optional.ofNullable(outputs.get(entry.element().name()));
    }
    feed.ifPresent(f -> f.take(entry, bytes));
  }

  synchronized void lost(String reason) {
    outputs.values().forEach(feed -> feed.lost(reason));
  }

  /** Says why nothing comes, or by an empty reason that it does. */
  synchronized void failed(String reason) {
    if (!reason.equals(told)) {
      told = reason;
      outputs.values().forEach(feed -> feed.failed(reason));
    }
  }

  @Override
  public synchronized void close() {
    drivings.values().forEach(BaseDriving::close);
    offers.forEach(Offer::close);
    outputs.values().forEach(OutputFeed::close);
  }
}
