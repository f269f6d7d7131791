package org.robotui.smartsoft;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import org.robotui.message.DefinitionException;
import org.robotui.message.IdlDefinitions;
import org.robotui.smartsoft.object.CommType;
import org.robotui.smartsoft.object.CommTypes;
import org.robotui.smartsoft.wire.NamingCommand;
import org.robotui.smartsoft.wire.SmartCommand;
import org.robotui.smartsoft.wire.SmartFrame;

/** What both parts of recorded frames consist of, as descriptions of their own. */
final class KnownParts {

  private static final IdlDefinitions PATTERNS = new IdlDefinitions(Map.of("Pattern", """
      module Pattern {
        struct Connect { long client; string identifier; };
        struct AckConnect { long client; long status; };
        struct Number { long number; };
        struct Long { long long number; };
        struct Subscribe { long every; long subscription; };
        struct Activate { long mode; long long activation; };
        struct Name { string name; };
        struct Entry { string name; string value; string type; };
        struct Status { long status; long error; };
      };
      """));
  private static final CommTypes TYPES = CommTypes.shipped();

  /** A part with what it consists of. */
  record Part(String what, CommType type, ByteBuffer bytes) {}

  private KnownParts() {}

  static Optional<Part> pattern(String file, SmartFrame frame) {
    ByteBuffer bytes = frame.pattern();
    if (!bytes.hasRemaining()) {
      return Optional.empty();
    }
    String name = file.startsWith("ns_") ? naming(file, frame) : service(frame);
    try {
      return Optional.of(new Part(file + " " + name, new CommType(name, PATTERNS.schema("Pattern/" + name)), bytes));
    } catch (DefinitionException e) {
      throw new AssertionError(e);
    }
  }

  private static String naming(String file, SmartFrame frame) {
    boolean asked = file.endsWith("c2s");
    return switch (frame.command()) {
      case NamingCommand.BIND -> asked ? "Entry" : frame.pattern().remaining() == 8 ? "Status" : "Entry";
      case NamingCommand.RESOLVE, NamingCommand.LIST -> asked ? "Name" : "Entry";
      case NamingCommand.UNBIND -> asked ? "Name" : "Status";
      case NamingCommand.END_OF_LIST -> "Entry";
      default -> throw new AssertionError(file + " has the command " + frame.command());
    };
  }

  private static String service(SmartFrame frame) {
    return switch (SmartCommand.of(frame.command()).orElseThrow()) {
      case CONNECT -> "Connect";
      case ACK_CONNECT -> "AckConnect";
      case UPDATE, ACK_SUBSCRIBE -> "Number";
      case SUBSCRIBE -> "Subscribe";
      case ACTIVATE -> "Activate";
      case REQUEST, ANSWER, EVENT, ACK_ACTIVATE, DEACTIVATE -> "Long";
      default -> throw new AssertionError("no data were recorded of " + frame);
    };
  }

  static Optional<Part> object(String file, SmartFrame frame) {
    if (!frame.object().hasRemaining()) {
      return Optional.empty();
    }
    boolean asked = file.endsWith("c2s");
    String name = switch (file.substring(0, file.indexOf('.'))) {
      case "push", "query_time" -> "exampleTime";
      case "query_calc" -> asked ? "exampleValues" : "exampleResult";
      case "event_morethan", "event_morethan2" -> asked ? "exampleEvent1Parameter" : "exampleEvent1Result";
      case "event_interval" -> asked ? "exampleEvent2Parameter" : "exampleEvent2Result";
      default -> "examplePrint";
    };
    CommType type = TYPES.get("SmartACE::" + name);
    return Optional.of(new Part(file + " " + name, type, frame.object()));
  }
}
