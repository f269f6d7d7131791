package org.robotui.rfic.player.internal.device;

import java.util.List;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.rfic.player.internal.convert.FrameNames;
import org.robotui.rfic.player.internal.link.Stamps;

/**
 * The frames of the robot: map, odometry, base, devices. Player has no transforms; these are made of what its devices
 * say. Safe for all threads.
 */
public final class FrameTree implements AutoCloseable {
  private final RficContext context;
  private final FrameNames names;
  private final Publication<TransformSet> publication;
  private volatile boolean wanted;
  private volatile Optional<RigidTransform> odomFromBase = Optional.empty();

  public FrameTree(RficContext context, FrameNames names) {
    this.context = context;
    this.names = names;
    Demand demand = now -> wanted = now;
    this.publication = context.offers().stream(new StreamPort<>("tf", TransformSet.class, Arity.MANY,
        "where base and devices are, made of odometry, localisation and geometry"), demand);
  }

  FrameNames names() {
    return names;
  }

  /** Whether somebody looks at the transforms themselves. */
  public boolean wanted() {
    return wanted;
  }

  /** A device is mounted on the base. */
  void mounted(FrameId child, RigidTransform baseFromChild, String authority) {
    add(new FrameTransform(names.base(), child, Stamps.wall(), baseFromChild, true), authority);
  }

  void mounted(List<FrameTransform> mounts, String authority) {
    if (!mounts.isEmpty()) {
      add(new TransformSet(mounts), Optional.empty(), authority);
    }
  }

  /** The base has moved. */
  void moved(Odometry odometry, Optional<Stamp> stamp, String authority) {
    odomFromBase = Optional.of(odometry.pose());
    if (!odometry.frame().equals(odometry.childFrame())) {
      add(new FrameTransform(odometry.frame(), odometry.childFrame(), stamp.orElseGet(Stamps::wall), odometry.pose(),
          false), authority);
    }
  }

  /** Localisation has spoken: the map carries the odometry. Nothing is to be said where both are one frame. */
  void located(PoseEstimate estimate, Optional<Stamp> stamp, String authority) {
    if (names.map().equals(names.odom())) {
      return;
    }
    odomFromBase.ifPresent(base -> add(new FrameTransform(names.map(), names.odom(), stamp.orElseGet(Stamps::wall),
        estimate.pose().times(base.inverse()), false), authority));
  }

  private void add(FrameTransform transform, String authority) {
    add(new TransformSet(List.of(transform)), Optional.of(transform.stamp()), authority);
  }

  private void add(TransformSet set, Optional<Stamp> stamp, String authority) {
    context.frames().add(set, authority);
    publication.publish(set, stamp);
  }

  @Override
  public void close() {
    publication.close();
  }
}
