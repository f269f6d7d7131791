package org.robotui.message.topic.internal;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.robotui.data.command.RelayMessage.Wire;
import org.robotui.message.DefinitionException;
import org.robotui.message.Encoding;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.topic.RecordedDefinitions;

/** Whether messages of another robot are of the very type of a topic. Senders seldom differ: one answer is kept. */
final class TypeAgreement {
  private static final String CDR = "cdr";

  private final MessageSchema schema;
  private String asked = "";
  private boolean agrees;

  TypeAgreement(MessageSchema schema) {
    this.schema = schema;
  }

  boolean with(Wire wire) {
    Optional<String> definition = wire.definition().get();
    if (definition.isEmpty()) {
      return false;
    }
    if (!definition.get().equals(asked)) {
      asked = definition.get();
      agrees = same(asked, wire.encoding().equals(CDR));
    }
    return agrees;
  }

  private boolean same(String definition, boolean second) {
    if (definition.equals(own(second))) {
      return true;
    }
    try {
      MessageSchema other = MessageSchema.parse(schema.definition().type(), definition,
          second ? Generation.ROS2 : Generation.ROS1);
      return other.info().md5().equals(schema.info().md5());
    } catch (DefinitionException e) {
      return false;
    }
  }

  private String own(boolean second) {
    return StandardCharsets.UTF_8.decode(RecordedDefinitions.of(schema, second ? Encoding.CDR : Encoding.ROS1)
        .content().buffer(ByteOrder.BIG_ENDIAN)).toString();
  }
}
