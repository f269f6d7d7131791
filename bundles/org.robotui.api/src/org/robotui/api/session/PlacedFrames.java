package org.robotui.api.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.geometry.RigidTransform;

/**
 * The frames of a robot whose framework has no transforms, made of what tells where things are: odometry, localisation,
 * offsets of sensors. They are offered as a stream as well. Safe for all threads.
 */
public final class PlacedFrames implements AutoCloseable {
  private static final long NANOS_PER_MILLI = 1_000_000;

  private final RficContext context;
  private final String authority;
  private final FrameId base;
  private final Publication<TransformSet> publication;
  private final Map<FrameId, RigidTransform> mounts = new ConcurrentHashMap<>();
  private volatile boolean wanted;

  /**
   * Offers the stream.
   *
   * @param context what core gives
   * @param authority who says it, for users
   * @param base the frame that carries sensors
   */
  public PlacedFrames(RficContext context, String authority, FrameId base) {
    this.context = context;
    this.authority = authority;
    this.base = base;
    this.publication = context.offers().stream(new StreamPort<>("tf", TransformSet.class, Arity.MANY,
        "where base and sensors are, made of odometry, localisation and offsets"), now -> wanted = now);
  }

  /**
   * Whether somebody wants the stream.
   *
   * @return false where nobody does
   */
  public boolean wanted() {
    return wanted;
  }

  /**
   * Something is somewhere now.
   *
   * @param parent the frame in which that is said
   * @param child what is there
   * @param pose where it is
   * @param stamp when; else now
   */
  public void placed(FrameId parent, FrameId child, RigidTransform pose, Optional<Stamp> stamp) {
    if (!parent.equals(child)) {
      add(List.of(new FrameTransform(parent, child, stamp.orElseGet(PlacedFrames::now), pose, false)));
    }
  }

  /**
   * Something is fixed to the base. It is said once, and again where it is elsewhere.
   *
   * @param child what is fixed
   * @param pose where it is on the base
   */
  public void mounted(FrameId child, RigidTransform pose) {
    if (pose.equals(mounts.put(child, pose))) {
      return;
    }
    add(List.of(new FrameTransform(base, child, now(), pose, true)));
  }

  private void add(List<FrameTransform> transforms) {
    TransformSet set = new TransformSet(transforms);
    context.frames().add(set, authority);
    publication.publish(set, Optional.of(transforms.getFirst().stamp()));
  }

  private static Stamp now() {
    return new Stamp(System.currentTimeMillis() * NANOS_PER_MILLI, ClockKind.ROBOT);
  }

  @Override
  public void close() {
    publication.close();
  }
}
