package org.robotui.message.topic;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.ServiceSchema;

/** Says in the fields of a response that a call was refused, for frameworks that have no other word for it. */
public final class ServiceRefusals {
  private static final String SUCCESS = "success";
  private static final List<String> REASONS = List.of("message", "status_message", "reason");

  private ServiceRefusals() {}

  /**
   * A response that says it.
   *
   * @param schema the type of the service
   * @param reason a sentence for users
   * @return the response; none where the type has no such fields
   */
  public static Optional<DynamicMessage> of(ServiceSchema schema, String reason) {
    List<String> fields = schema.response().definition().fields().stream().map(field -> field.name()).toList();
    Optional<String> said = REASONS.stream().filter(fields::contains).findFirst();
    if (!fields.contains(SUCCESS) || said.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(new DynamicCodec(schema.response()).build(Map.of(SUCCESS, false, said.get(), reason)));
    } catch (MessageException e) {
      return Optional.empty();
    }
  }
}
