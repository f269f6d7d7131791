package org.robotui.rfic.ros.internal.call;

import java.util.Optional;
import org.robotui.api.port.ActionReply;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageRegistry;
import org.robotui.message.SchemaLookup;
import org.robotui.message.topic.ActionHosting;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosNode;
import org.robotui.ros.action.ActionInfo;
import org.robotui.ros.action.ActionServer;
import org.robotui.ros.action.ActionWire;
import org.robotui.ros.action.Actions;
import org.robotui.ros.action.GoalEnd;
import org.robotui.ros.action.GoalTaker;

/**
 * Offers actions to nodes of ROS 1.
 *
 * @param node offers them
 * @param registry knows definitions
 */
public record RosActionHosting(RosNode node, MessageRegistry registry) implements ActionHosting<ActionWire> {
  private static final String SUFFIX = "Action";

  /** What is {@code X} in ROS 2 is {@code XAction} here. */
  @Override
  public SchemaLookup<Form<ActionWire>> form(String type) {
    String name = type.endsWith(SUFFIX) ? type : type + SUFFIX;
    return switch (ActionWire.find(name, registry)) {
      case SchemaLookup.Missing<ActionWire> missing -> new SchemaLookup.Missing<>(missing.reason());
      case SchemaLookup.Found<ActionWire> found -> new SchemaLookup.Found<>(
          new Form<>(name, found.schema().type().result(), found.schema().type().feedback(), found.schema()));
    };
  }

  @Override
  public Optional<String> provider(String action) {
    return Actions.list(node.master()).toOptional().stream().flatMap(all -> all.stream())
        .filter(each -> each.name().text().equals(action)).map(ActionInfo::server)
        .filter(server -> !server.equals(node.name().text())).findFirst();
  }

  @Override
  public Hosted open(String action, Form<ActionWire> form, Host host) {
    ActionServer server = ActionServer.open(node, GraphName.of(action), form.known(),
        (goal, client, taken) -> host.begin(goal, client, new Answer(taken)));
    return new Hosted() {
      @Override
      public void tick() {
        server.tick();
      }

      @Override
      public void close() {
        server.close();
      }
    };
  }

  private record Answer(GoalTaker.Taken taken) implements Heard {
    @Override
    public void begun() {
      taken.begun();
    }

    @Override
    public void feedback(DynamicMessage feedback) {
      taken.feedback(feedback);
    }

    @Override
    public void end(ActionReply.End end, String text, Optional<DynamicMessage> result) {
      taken.end(GoalEnd.valueOf(end.name()), text, result);
    }
  }
}
