package org.robotui.bridge.internal.change;

import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.record.DynamicRecord;

/**
 * What becomes of requests and replies between two robots; of actions, of goals, feedback and results.
 *
 * @param requests frames and stamps of requests
 * @param replies the same the other way
 * @param fields what requests are made of, where that is configured
 * @param reply what replies are made of, where that is configured
 * @param feedback what feedback is made of, where that is configured
 */
public record ServiceMapping(ValueRewriting requests, ValueRewriting replies, Optional<FieldMapping> fields,
    Optional<FieldMapping> reply, Optional<FieldMapping> feedback) {

  /** As configured. */
  public static ServiceMapping of(Settings settings, ValueRewriting requests, ValueRewriting replies) {
    return new ServiceMapping(requests, replies, FieldMapping.of(settings, "fields", "request"),
        FieldMapping.of(settings, "reply", "reply"), FieldMapping.of(settings, "feedback", "feedback"));
  }

  /**
   * The arguments of the call for a request.
   *
   * @throws IllegalArgumentException where a field is not there; names it
   */
  public Map<String, Object> request(DynamicRecord request) {
    return PlainArguments.of(mapped(fields, requests.of(request, Optional.empty())));
  }

  /**
   * The reply for the robot that asked.
   *
   * @throws IllegalArgumentException where a field is not there; names it
   */
  public DynamicRecord reply(DynamicRecord answer) {
    return mapped(reply, replies.of(answer, Optional.empty()));
  }

  /**
   * The feedback for the robot that sent the goal.
   *
   * @throws IllegalArgumentException where a field is not there; names it
   */
  public DynamicRecord feedback(DynamicRecord said) {
    return mapped(feedback, replies.of(said, Optional.empty()));
  }

  private static DynamicRecord mapped(Optional<FieldMapping> mapping, DynamicRecord record) {
    return mapping.map(m -> m.of(record, Optional.empty())).orElse(record);
  }
}
