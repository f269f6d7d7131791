package org.robotui.ros2;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.EndpointKind;
import org.robotui.rtps.Qos;
import org.robotui.rtps.VendorId;

/** A domain without a network: the participants of one test hear each other by calls. */
final class FakeDomain implements AutoCloseable {

  private final List<FakeParticipant> participants = new CopyOnWriteArrayList<>();
  private final AtomicInteger count = new AtomicInteger();

  FakeParticipant participant(VendorId vendor) {
    FakeParticipant made = new FakeParticipant(this, count.incrementAndGet(), vendor);
    participants.add(made);
    return made;
  }

  Ros2Context context() {
    return context(VendorId.FAST_DDS);
  }

  Ros2Context context(VendorId vendor) {
    return Ros2Context.on(participant(vendor), Ros2Environment.local(0), Ros2Options.standard(Thread::new));
  }

  List<FakeParticipant> others(FakeParticipant self) {
    List<FakeParticipant> all = new ArrayList<>(participants);
    all.remove(self);
    return all;
  }

  void left(FakeParticipant gone) {
    participants.remove(gone);
  }

  static boolean match(EndpointInfo a, EndpointInfo b) {
    EndpointInfo writer = a.kind() == EndpointKind.WRITER ? a : b;
    EndpointInfo reader = writer == a ? b : a;
    return sameTopic(a, b) && Qos.mismatch(writer.qos(), reader.qos()).isEmpty();
  }

  static boolean sameTopic(EndpointInfo a, EndpointInfo b) {
    return a.kind() != b.kind() && a.topic().equals(b.topic()) && a.type().equals(b.type());
  }

  static ByteBuffer copy(ByteBuffer payload) {
    return ByteBuffer.allocate(payload.remaining()).put(payload.duplicate()).flip().asReadOnlyBuffer();
  }

  @Override
  public void close() {
    participants.forEach(FakeParticipant::close);
  }
}
