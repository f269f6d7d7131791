package org.robotui.rtps.internal.participant;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import org.robotui.rtps.EntityId;
import org.robotui.rtps.Sample;
import org.robotui.rtps.internal.endpoint.Change;
import org.robotui.rtps.internal.endpoint.EndpointOutlet;
import org.robotui.rtps.internal.wire.InlineQos;
import org.robotui.rtps.internal.wire.SequenceSet;
import org.robotui.rtps.internal.wire.Submessage;

/** Makes submessages of what ends say. */
abstract class SubmessageBatch implements EndpointOutlet.Batch {

  static final ByteOrder ORDER = ByteOrder.LITTLE_ENDIAN;

  private static final ByteBuffer NO_QOS = ByteBuffer.allocate(0).asReadOnlyBuffer().order(ORDER);

  /** Takes a submessage, with the time of its sample or {@link Sample#NO_TIME}. */
  abstract void say(Submessage.Exchanged part, long time);

  @Override
  public final void data(EntityId reader, EntityId writer, Change change) {
    boolean alive = change.kind() == Sample.Kind.ALIVE;
    Submessage.Content key =
        change.payload().hasRemaining() ? Submessage.Content.KEY : Submessage.Content.NOTHING;
    say(new Submessage.Data(reader, writer, change.sequence(), inlineQos(change),
        alive ? Submessage.Content.SAMPLE : key, change.payload()), change.sourceNanos());
  }

  @Override
  public final void fragment(EntityId reader, EntityId writer, Change change, int size, long number) {
    int begin = change.payload().position() + (int) (number - 1) * size;
    int length = Math.min(size, change.payload().limit() - begin);
    say(new Submessage.DataFrag(reader, writer, change.sequence(), number, 1, size, change.payload().remaining(),
        inlineQos(change), false, change.payload().slice(begin, length)), change.sourceNanos());
  }

  @Override
  public final void heartbeat(EntityId reader, EntityId writer, long first, long last, int count, boolean answer) {
    say(new Submessage.Heartbeat(reader, writer, first, last, count, !answer, false), Sample.NO_TIME);
  }

  @Override
  public final void alive(EntityId reader, EntityId writer, long first, long last, int count) {
    say(new Submessage.Heartbeat(reader, writer, first, last, count, true, true), Sample.NO_TIME);
  }

  @Override
  public final void gap(EntityId reader, EntityId writer, long start, SequenceSet set) {
    say(new Submessage.Gap(reader, writer, start, set), Sample.NO_TIME);
  }

  @Override
  public final void acknowledge(EntityId reader, EntityId writer, SequenceSet missing, int count, boolean answer) {
    say(new Submessage.AckNack(reader, writer, missing, count, !answer), Sample.NO_TIME);
  }

  @Override
  public final void missingFragments(EntityId reader, EntityId writer, long sequence, SequenceSet missing,
      int count) {
    say(new Submessage.NackFrag(reader, writer, sequence, missing, count), Sample.NO_TIME);
  }

  private static ByteBuffer inlineQos(Change change) {
    if (change.kind() == Sample.Kind.ALIVE) {
      return change.related().isEmpty() ? NO_QOS
          : new InlineQos(false, false, change.related(), Optional.empty()).bytes(ORDER);
    }
    // who forgets an instance that ended has forgotten its writer's part as well
    return new InlineQos(change.kind() == Sample.Kind.DISPOSED, true, change.related(), change.instance())
        .bytes(ORDER);
  }
}
