package org.robotui.message.description;

import java.util.Optional;
import org.robotui.message.ActionDefinition;
import org.robotui.message.ActionSchema;
import org.robotui.message.DefinitionException;
import org.robotui.message.DefinitionSource;
import org.robotui.message.Definitions;
import org.robotui.message.MessageDefinition;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageSchema;
import org.robotui.message.ServiceDefinition;
import org.robotui.message.ServiceSchema;

/** A place that knows types: definitions, or the description of one type by a node. */
sealed interface TypeKnowledge {

  Optional<MessageSchema> message(TypeName name) throws DefinitionException;

  Optional<ServiceSchema> service(TypeName name) throws DefinitionException;

  Optional<ActionSchema> action(TypeName name) throws DefinitionException;

  /** Definitions, with what they refer to. */
  record Defined(Definitions own, DefinitionSource all) implements TypeKnowledge {

    @Override
    public Optional<MessageSchema> message(TypeName name) throws DefinitionException {
      return switch (name.kind()) {
        case MSG -> plain(name);
        case SRV -> partOfService(name);
        case ACTION -> {
          Optional<MessageSchema> part = partOfAction(name);
          yield part.isPresent() ? part : partOfService(name);
        }
      };
    }

    private Optional<MessageSchema> plain(TypeName name) throws DefinitionException {
      Optional<MessageDefinition> found = own.find(name.plain());
      return found.isEmpty() ? Optional.empty() : Optional.of(MessageSchema.resolve(found.get(), all));
    }

    private Optional<MessageSchema> partOfService(TypeName name) throws DefinitionException {
      Optional<TypeName> asked = name.whole("Request");
      Optional<TypeName> whole = asked.isPresent() ? asked : name.whole("Response");
      Optional<ServiceSchema> service = whole.isEmpty() ? Optional.empty() : service(whole.get());
      return service.map(found -> asked.isPresent() ? found.request() : found.response());
    }

    private Optional<MessageSchema> partOfAction(TypeName name) throws DefinitionException {
      for (String part : ActionParts.MESSAGES) {
        Optional<TypeName> whole = name.whole(part);
        Optional<ActionSchema> action = whole.isEmpty() ? Optional.empty() : action(whole.get());
        if (action.isPresent()) {
          return action.map(found -> switch (part) {
            case "Goal" -> found.goal();
            case "Result" -> found.result();
            case "Feedback" -> found.feedback();
            default -> found.feedbackMessage();
          });
        }
      }
      return Optional.empty();
    }

    @Override
    public Optional<ServiceSchema> service(TypeName name) throws DefinitionException {
      if (name.kind() == TypeName.Kind.ACTION) {
        Optional<TypeName> sending = name.whole("SendGoal");
        Optional<TypeName> whole = sending.isPresent() ? sending : name.whole("GetResult");
        Optional<ActionSchema> action = whole.isEmpty() ? Optional.empty() : action(whole.get());
        return action.map(found -> sending.isPresent() ? found.sendGoal() : found.getResult());
      }
      Optional<ServiceDefinition> found = own.service(name.plain());
      return found.isEmpty() ? Optional.empty() : Optional.of(ServiceSchema.resolve(found.get(), all));
    }

    @Override
    public Optional<ActionSchema> action(TypeName name) throws DefinitionException {
      Optional<ActionDefinition> found = own.action(name.plain());
      return found.isEmpty() ? Optional.empty() : Optional.of(ActionSchema.resolve(found.get(), all));
    }
  }

  /** What a node described. It has no sum of ROS 1. */
  record Described(DescribedType type) implements TypeKnowledge {

    @Override
    public Optional<MessageSchema> message(TypeName name) throws DefinitionException {
      Optional<MessageSchema> sourced = SourceTexts.schema(type);
      return Optional.of(sourced.isPresent() ? sourced.get() : type.description().schema());
    }

    @Override
    public Optional<ServiceSchema> service(TypeName name) throws DefinitionException {
      return Optional.of(new ServiceSchema(name.plain(), MessageInfo.ANY, part(name.part("Request")),
          part(name.part("Response"))));
    }

    @Override
    public Optional<ActionSchema> action(TypeName name) throws DefinitionException {
      ServiceSchema send = service(name.part("SendGoal")).orElseThrow();
      ServiceSchema get = service(name.part("GetResult")).orElseThrow();
      return Optional.of(new ActionSchema(name.plain(), part(name.part("Goal")), part(name.part("Result")),
          part(name.part("Feedback")), send, get, part(name.part("FeedbackMessage"))));
    }

    private MessageSchema part(TypeName name) throws DefinitionException {
      try {
        return type.description().part(name.toString()).schema();
      } catch (IllegalArgumentException e) {
        throw new DefinitionException(name.toString(), e.getMessage());
      }
    }
  }
}
