package org.robotui.rfic.ros.internal.convert;

import org.robotui.data.DynamicRecord;
import org.robotui.ros.message.DynamicCodec;
import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageRegistry;
import org.robotui.ros.message.MessageSchema;
import org.robotui.ros.message.RawMessage;
import org.robotui.ros.message.SchemaLookup;

/** Decodes messages of any type by the definition that came with the connection. */
final class RecordDecoder {
  private final MessageRegistry registry;

  RecordDecoder(MessageRegistry registry) {
    this.registry = registry;
  }

  DynamicRecord decode(RawMessage message) {
    return switch (registry.learn(message.info())) {
      case SchemaLookup.Found<MessageSchema> f -> decode(message, f.schema());
      case SchemaLookup.Missing<MessageSchema> m -> throw new IllegalArgumentException(m.reason());
    };
  }

  private static DynamicRecord decode(RawMessage message, MessageSchema schema) {
    try {
      return new RosRecord(new DynamicCodec(schema).decode(message.bytes()));
    } catch (MessageException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }
}
