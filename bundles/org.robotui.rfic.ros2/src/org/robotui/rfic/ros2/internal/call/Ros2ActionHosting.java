package org.robotui.rfic.ros2.internal.call;

import java.util.Optional;
import org.robotui.api.port.ActionReply;
import org.robotui.message.ActionSchema;
import org.robotui.message.DynamicMessage;
import org.robotui.message.RosValue;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeName;
import org.robotui.message.topic.ActionHosting;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Types.TypedAction;
import org.robotui.ros2.action.Ros2ActionServer;
import org.robotui.ros2.action.Ros2GoalEnd;
import org.robotui.ros2.action.Ros2GoalTaker;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.name.Ros2Name;

/**
 * Offers actions to nodes of ROS 2, whose clients get no words with the end of a goal.
 *
 * @param node offers them
 */
public record Ros2ActionHosting(Ros2Node node) implements ActionHosting<TypedAction> {
  private static final String SUFFIX = "Action";
  private static final String CODE = "error_code";

  /** What is {@code XAction} in ROS 1 is {@code X} here. */
  @Override
  public SchemaLookup<Form<TypedAction>> form(String type) {
    String plain = type.endsWith(SUFFIX) ? type.substring(0, type.length() - SUFFIX.length()) : type;
    Optional<TypeName> name = TypeName.parse(plain, TypeName.Kind.ACTION);
    if (name.isEmpty()) {
      return new SchemaLookup.Missing<>("'" + type + "' is no name of a type of actions");
    }
    return switch (node.context().types().registry().action(name.get(), Optional.empty())) {
      case SchemaLookup.Missing<ActionSchema> missing -> new SchemaLookup.Missing<>(missing.reason());
      case SchemaLookup.Found<ActionSchema> found -> new SchemaLookup.Found<>(new Form<>(plain, found.schema().result(),
          found.schema().feedback(), new TypedAction(name.get(), found.schema())));
    };
  }

  @Override
  public Optional<String> provider(String action) {
    return Ros2Name.parse(action).flatMap(node.context().graph().state()::action).stream()
        .flatMap(known -> known.servers().stream()).filter(end -> !end.own()).map(GraphEnd::who).findFirst();
  }

  @Override
  public Hosted open(String action, Form<TypedAction> form, Host host) {
    return Ros2ActionServer.open(node, action, form.known(),
        (goal, taken) -> host.begin(goal, "", new Answer(taken)))::close;
  }

  private record Answer(Ros2GoalTaker.Taken taken) implements Heard {
    @Override
    public void begun() {
      taken.accept();
    }

    @Override
    public void feedback(DynamicMessage feedback) {
      taken.feedback(feedback);
    }

    /** A goal that is rejected has no result in ROS 2: one that says why with a code is aborted, so that it arrives. */
    @Override
    public void end(ActionReply.End end, String text, Optional<DynamicMessage> result) {
      taken.end(switch (end) {
        case SUCCEEDED -> Ros2GoalEnd.SUCCEEDED;
        case ABORTED, LOST -> Ros2GoalEnd.ABORTED;
        case REJECTED -> result.filter(Answer::saysWhy).isPresent() ? Ros2GoalEnd.ABORTED : Ros2GoalEnd.REJECTED;
        case PREEMPTED, RECALLED -> Ros2GoalEnd.CANCELED;
      }, result);
    }

    private static boolean saysWhy(DynamicMessage result) {
      return result.field(CODE).filter(value -> value instanceof RosValue.Whole code && code.value() != 0).isPresent();
    }
  }
}
