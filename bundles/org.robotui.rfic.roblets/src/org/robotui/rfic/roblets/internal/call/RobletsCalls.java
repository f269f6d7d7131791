package org.robotui.rfic.roblets.internal.call;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.rfic.roblets.internal.convert.InputMeaning;
import org.robotui.rfic.roblets.internal.feed.BodyFeeds;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.watch.BodyWatcher;

/** Says messages to roblets, by {@code ROBLET/MESSAGE}. What drives is left to views for driving. */
public final class RobletsCalls implements CallHandler<ServiceRequest, ServiceReply> {
  private final BodyFeeds feeds;
  private final BodyWatcher watcher;

  public RobletsCalls(BodyFeeds feeds, BodyWatcher watcher) {
    this.feeds = feeds;
    this.watcher = watcher;
  }

  @Override
  public ServiceReply handle(Invocation<ServiceRequest> invocation) throws CallException {
    ServiceRequest asked = invocation.request();
    BodyFeeds.Input input = feeds.input(asked.service())
        .orElseThrow(() -> new CallException("no roblet is there that takes '" + asked.service() + "'"));
    if (InputMeaning.isVelocity(input.form())) {
      throw new CallException("'" + asked.service() + "' drives the robot; use a view for driving");
    }
    Optional<String> refusal = feeds.refusal(input.roblet());
    if (refusal.isPresent()) {
      throw new CallException(refusal.get());
    }
    try {
      if (!watcher.ask(input.roblet(), message(input.form(), asked.arguments()))) {
        throw new CallException("the brain cannot be reached");
      }
    } catch (IllegalArgumentException e) {
      throw new CallException(e.getMessage(), e);
    }
    // nobody answers a message: what became of it is seen in what the roblet says
    return new ServiceReply(new MapRecord("roblets/Sent", Map.of("sent", new FieldValue.Flag(true))));
  }

  private static BodyElement message(BodyForm form, Map<String, Object> arguments) {
    List<String> known = form.fields().stream().map(BodyForm.Field::name).toList();
    return element(form.name(), "", arguments, known);
  }

  private static BodyElement element(String name, String before, Map<?, ?> arguments, List<String> known) {
    Map<String, String> attributes = new LinkedHashMap<>();
    List<BodyElement> children = new ArrayList<>();
    arguments.forEach((key, value) -> {
      String path = before + key;
      if (value instanceof Map<?, ?> inner) {
        children.add(element(String.valueOf(key), path + "/", inner, known));
      } else if (known.contains(path)) {
        attributes.put(String.valueOf(key), String.valueOf(value));
      } else {
        throw new IllegalArgumentException("there is no '" + path + "'; it has " + String.join(", ", known));
      }
    });
    return new BodyElement(name, attributes, "", children);
  }
}
