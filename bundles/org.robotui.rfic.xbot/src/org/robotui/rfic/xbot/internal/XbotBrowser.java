package org.robotui.rfic.xbot.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.topic.ItemFacts;
import org.robotui.rfic.xbot.internal.follow.FollowActions;

/** What of a control can be called: actions that follow trajectories, and the service that stops plugins. */
final class XbotBrowser implements Browser {
  private static final String NOT_HERE = "a real-time control has no such thing as ";

  private final FollowActions actions;
  private final MessageRegistry types =
      new MessageRegistry(new LocalDefinitions(List.of(), List.of()), Generation.ROS1);

  XbotBrowser(FollowActions actions) {
    this.actions = actions;
  }

  @Override
  public List<Item> list(Kind kind) {
    return switch (kind) {
      case ACTION -> actions.names().stream().map(name -> new Item(kind, name, FollowActions.TYPE)).toList();
      case SERVICE -> List.of(new Item(kind, StopService.NAME, ""));
      case TOPIC, NODE, PARAMETER, TUNABLE -> List.of();
    };
  }

  @Override
  public Description describe(Item item) throws CallException {
    return switch (item.kind()) {
      case ACTION -> {
        ItemFacts facts = new ItemFacts().with("type", item.type());
        yield facts.ofCall(item, List.of(schema("Goal"), schema("Result")));
      }
      case SERVICE -> new ItemFacts().ofCall(item, List.of());
      case TOPIC, NODE, PARAMETER, TUNABLE -> throw new CallException(NOT_HERE + item.name());
    };
  }

  private MessageSchema schema(String part) throws CallException {
    if (types.message(FollowActions.TYPE + part) instanceof SchemaLookup.Found<MessageSchema> found) {
      return found.schema();
    }
    throw new CallException("the definition of " + FollowActions.TYPE + " is not known here");
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException(NOT_HERE + "parameters");
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException(NOT_HERE + "settings of programs");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    return tunables(item);
  }
}
