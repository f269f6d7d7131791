package org.robotui.rfic.player.internal.device;

import java.util.Set;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.RangeReadings;

/** A stream of a device. Core's thread merely notes the demand; the thread that follows the devices acts on it. */
final class Outlet<D extends Data> implements AutoCloseable {
  private static final Set<Class<?>> PLACED =
      Set.of(LaserScan.class, RangeReadings.class, PointCloud.class, PoseArray.class,
          PoseEstimate.class, Footprint.class, Bumpers.class);

  private final Publication<D> publication;
  private final boolean placed;
  private volatile boolean wanted;
  private volatile boolean closed;

  Outlet(RficContext context, String name, Class<D> type, String help) {
    this.placed = PLACED.contains(type);
    this.publication = context.offers().stream(new StreamPort<>(name, type, Arity.MANY, help), now -> wanted = now);
  }

  boolean wanted() {
    return wanted && !closed;
  }

  /** Whether what is published says something only to those who know where the robot is. */
  boolean placed() {
    return placed;
  }

  void publish(D value, Reception reception) {
    publication.publish(value, reception.stamp(), reception.nanos(), reception.raw());
  }

  void lost(String reason) {
    publication.lost(1, reason);
  }

  void failed(String reason) {
    publication.failed(reason);
  }

  @Override
  public void close() {
    closed = true;
    publication.close();
  }
}
