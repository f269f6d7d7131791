package org.robotui.rtps.internal.participant;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.robotui.rtps.internal.wire.Submessage;

/** What one of our ends says to another one of this participant: it needs no network. */
final class LocalBatch extends SubmessageBatch {

  private final Consumer<List<Said>> receiver;
  private final List<Said> said = new ArrayList<>();

  /** A submessage, and when its sample was written. */
  record Said(Submessage.Exchanged part, long time) {}

  LocalBatch(Consumer<List<Said>> receiver) {
    this.receiver = receiver;
  }

  @Override
  void say(Submessage.Exchanged part, long at) {
    said.add(new Said(part, at));
  }

  @Override
  public void close() {
    if (!said.isEmpty()) {
      receiver.accept(List.copyOf(said));
    }
  }
}
