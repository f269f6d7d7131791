package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;
import org.robotui.xbot.StateFrame;
import org.robotui.xbot.StateFrame.Control;
import org.robotui.xbot.StateFrame.Hardware;
import org.robotui.xbot.Timing;

/** Reads what the HAL writes. */
public final class StateReader {
  private static final Control[] CONTROLS = Control.values();
  private static final Hardware[] HARDWARE = Hardware.values();

  private final Layout.Field frames;
  private final Layout.Field loop;
  private final int newest;
  private final int joints;
  private final int imus;
  private final int forceTorques;
  private final int sequence;
  private final int data;
  private final FrameFields frame;
  private final TimingReader timing;

  /** A reader of states of this layout. */
  public StateReader(Layout layout) {
    this.frames = layout.struct("StateSegment").fields().get("frames");
    this.loop = layout.struct("StateSegment").fields().get("loop");
    this.newest = layout.offset("StateSegment", "newest");
    this.joints = layout.offset("StateSegment", "joints");
    this.imus = layout.offset("StateSegment", "imus");
    this.forceTorques = layout.offset("StateSegment", "force_torques");
    this.sequence = layout.offset("StateFrame", "sequence");
    this.data = layout.offset("StateFrame", "data");
    this.frame = new FrameFields(layout);
    this.timing = new TimingReader(layout);
  }

  /** The number of the newest cycle, 0 before the first. */
  public long newest(Memory memory) {
    return memory.acquireLong(newest);
  }

  /** Room to read with. */
  FrameCopy newCopy() {
    return new FrameCopy(frame.size);
  }

  /** The newest frame; none before the first, or where the HAL died while it wrote one. */
  Optional<StateFrame> read(Memory memory, FrameCopy copy) {
    long cycle = newest(memory);
    return cycle == 0 || !take(memory, cycle, copy) ? Optional.empty() : Optional.of(frame(memory, copy));
  }

  /** The frame of a cycle; none where another one lies there by now, or is being written. */
  Optional<StateFrame> read(Memory memory, long cycle, FrameCopy copy) {
    if (!take(memory, cycle, copy)) {
      return Optional.empty();
    }
    StateFrame there = frame(memory, copy);
    return there.cycle() == cycle ? Optional.of(there) : Optional.empty();
  }

  /** The oldest cycle that is not about to be written over, while this is the newest one. */
  public long oldest(long newestCycle) {
    return Math.max(1, newestCycle - (frames.count() - 2));
  }

  private boolean take(Memory memory, long cycle, FrameCopy copy) {
    int at = frames.offset() + (int) Long.remainderUnsigned(cycle, frames.count()) * frames.size();
    return copy.take(memory, at + sequence, at + data);
  }

  /** How the HAL keeps its time. */
  public Timing loop(Memory memory) {
    return timing.loop(memory.copy(loop.offset(), loop.size()));
  }

  /** The joints are made for each copy that was taken: it compares them with those before. */
  private StateFrame frame(Memory memory, FrameCopy copy) {
    ByteBuffer from = copy.bytes();
    return new StateFrame(
        from.getLong(frame.cycle),
        from.getLong(frame.sensed),
        HARDWARE[Math.clamp(from.getInt(frame.status), 0, HARDWARE.length - 1)],
        copy.joints(frame.joints, count(memory, joints, frame.joints), at -> joint(from, at)),
        many(memory, imus, frame.imus, at -> imu(from, at)),
        many(memory, forceTorques, frame.forceTorques, at -> forceTorque(from, at)));
  }

  private static <T> List<T> many(Memory memory, int count, Layout.Field field, IntFunction<T> one) {
    int there = count(memory, count, field);
    List<T> all = new ArrayList<>(there);
    for (int i = 0; i < there; i++) {
      all.add(one.apply(field.offset() + i * field.size()));
    }
    return List.copyOf(all);
  }

  private static int count(Memory memory, int count, Layout.Field field) {
    return Math.clamp(memory.readInt(count), 0, field.count());
  }

  private StateFrame.Joint joint(ByteBuffer from, int at) {
    JointFields joint = frame.joint;
    int owner = Short.toUnsignedInt(from.getShort(at + joint.owner));
    return new StateFrame.Joint(
        from.getDouble(at + joint.linkPosition),
        from.getDouble(at + joint.motorPosition),
        from.getDouble(at + joint.linkVelocity),
        from.getDouble(at + joint.motorVelocity),
        from.getDouble(at + joint.effort),
        new StateFrame.Reference(
            from.getDouble(at + joint.positionReference),
            from.getDouble(at + joint.velocityReference),
            from.getDouble(at + joint.effortReference),
            from.getDouble(at + joint.stiffness),
            from.getDouble(at + joint.damping)),
        Byte.toUnsignedInt(from.get(at + joint.mode)),
        from.getFloat(at + joint.motorTemperature),
        from.getFloat(at + joint.driverTemperature),
        Integer.toUnsignedLong(from.getInt(at + joint.fault)),
        Integer.toUnsignedLong(from.getInt(at + joint.clamped)),
        Integer.toUnsignedLong(from.getInt(at + joint.rejected)),
        owner == joint.nobody ? -1 : owner,
        CONTROLS[Math.clamp(from.get(at + joint.control), 0, CONTROLS.length - 1)]);
  }

  private StateFrame.Imu imu(ByteBuffer from, int at) {
    int rotation = at + frame.orientation;
    return new StateFrame.Imu(
        new Quaternion(from.getDouble(rotation), from.getDouble(rotation + Double.BYTES),
            from.getDouble(rotation + 2 * Double.BYTES), from.getDouble(rotation + 3 * Double.BYTES)),
        vector(from, at + frame.angularVelocity),
        vector(from, at + frame.linearAcceleration));
  }

  private StateFrame.ForceTorque forceTorque(ByteBuffer from, int at) {
    return new StateFrame.ForceTorque(vector(from, at + frame.force), vector(from, at + frame.torque));
  }

  private static Vector3 vector(ByteBuffer from, int at) {
    return new Vector3(from.getDouble(at), from.getDouble(at + Double.BYTES), from.getDouble(at + 2 * Double.BYTES));
  }
}
