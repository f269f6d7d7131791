package org.robotui.rfic.carmen.internal.feed;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.carmen.module.MessageSender;

/**
 * Who sends the messages that the robot is told; made on the thread that follows, so that commands wait for nothing.
 */
final class Telling {
  private final Shared shared;
  private final Map<String, MessageSender> senders = new ConcurrentHashMap<>();

  Telling(Shared shared) {
    this.shared = shared;
  }

  /** Makes ready to send a message; blocks. */
  void prepare(String message) throws IOException {
    MessageSender known = senders.get(message);
    if (known == null) {
      senders.put(message, shared.module().sender(shared.forms().get(message)));
    } else {
      known.refresh();
    }
  }

  boolean isReady(String message) {
    return senders.containsKey(message);
  }

  /** Begins a message with its time and ourselves in it. */
  IpcRecordMaker make(String message) {
    return Optional.ofNullable(senders.get(message)).map(sender -> sender.form().make())
        .orElseGet(() -> shared.forms().get(message).make()).number("timestamp", shared.now())
        .text("host", shared.module().name());
  }

  /** Sends it, in place of an older one that waits; false where the link is gone. */
  boolean tell(String message, IpcRecord record) {
    MessageSender sender = senders.get(message);
    return sender != null && sender.command(record);
  }
}
