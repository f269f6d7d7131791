package org.robotui.rfic.ros.internal.convert;

import java.nio.ByteOrder;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.RawMessage;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageRecord;

/** Decodes messages of any type by the definition that came with the connection. */
public final class RecordDecoder {
  private final MessageRegistry registry;

  /**
   * Creates a decoder.
   *
   * @param registry knows message definitions
   */
  public RecordDecoder(MessageRegistry registry) {
    this.registry = registry;
  }

  /**
   * Reads a message.
   *
   * @param info its type
   * @param bytes its bytes
   * @return its fields, or none where they cannot be read
   */
  public Optional<DynamicRecord> read(MessageInfo info, Bytes bytes) {
    try {
      return Optional.of(new MessageRecord(decode(new RawMessage(info, bytes.buffer(ByteOrder.LITTLE_ENDIAN)))));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /**
   * What it decodes by.
   *
   * @return knows message definitions
   */
  public MessageRegistry registry() {
    return registry;
  }

  DynamicMessage decode(RawMessage message) {
    return switch (registry.learn(message.info())) {
      case SchemaLookup.Found<MessageSchema> f -> decode(message, f.schema());
      case SchemaLookup.Missing<MessageSchema> m -> throw new IllegalArgumentException(m.reason());
    };
  }

  private static DynamicMessage decode(RawMessage message, MessageSchema schema) {
    try {
      return new DynamicCodec(schema).decode(message.bytes());
    } catch (MessageException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }
}
