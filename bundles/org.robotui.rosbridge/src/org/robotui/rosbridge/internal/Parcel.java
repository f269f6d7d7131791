package org.robotui.rosbridge.internal;

import java.nio.ByteBuffer;
import java.util.Map;
import org.robotui.rosbridge.BridgeMessage;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/**
 * A message of a topic that has arrived and was not opened yet, so that what gives way to a newer one costs nothing.
 */
public sealed interface Parcel {

  /** How long it is. */
  long size();

  /** When it was received, by {@link System#nanoTime()}. */
  long receivedNanos();

  /** What is in it. */
  BridgeMessage open() throws TreeException;

  /** In JSON. */
  record Text(String text, long receivedNanos) implements Parcel {
    @Override
    public long size() {
      return 2L * text.length();
    }

    @Override
    public BridgeMessage open() throws TreeException {
      Map<String, Object> message = Trees.object(JsonText.read(text));
      return new BridgeMessage.Tree(Trees.object(message.get("msg")));
    }
  }

  /** Of CBOR, which has to be read to know the topic. */
  record Tree(Map<String, Object> message, long size, long receivedNanos) implements Parcel {
    @Override
    public BridgeMessage open() throws TreeException {
      Map<String, Object> fields = Trees.object(message.get("msg"));
      return fields.get("bytes") instanceof byte[] bytes && fields.containsKey("secs")
          ? new BridgeMessage.Raw(ByteBuffer.wrap(bytes))
          : new BridgeMessage.Tree(fields);
    }
  }
}
