package org.robotui.rfic.yarp.internal.call;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.data.record.FieldShape;
import org.robotui.data.record.RecordShape;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.feed.Wires;
import org.robotui.rfic.yarp.internal.feed.YarpDevice;
import org.robotui.rfic.yarp.internal.feed.YarpDevices;
import org.robotui.yarp.port.PortAdmin;

/** What a name server knows of the robot: its ports as topics, and those that are asked as services. */
public final class YarpBrowser implements Browser {
  private final Wires wires;
  private final YarpDevices devices;

  public YarpBrowser(Wires wires, YarpDevices devices) {
    this.wires = wires;
    this.devices = devices;
  }

  @Override
  public List<Item> list(Kind kind) {
    return switch (kind) {
      case TOPIC -> items(kind, false);
      case SERVICE -> items(kind, true);
      case NODE, PARAMETER, ACTION, TUNABLE -> List.of();
    };
  }

  private List<Item> items(Kind kind, boolean asked) {
    return devices.kinds().entrySet().stream()
        .filter(e -> e.getValue() != YarpDevice.NONE && e.getValue().asked() == asked)
        .map(e -> new Item(kind, e.getKey(), e.getValue().word())).toList();
  }

  /** Whom a port says its messages to is asked from the port itself, and what it takes from the name server. */
  @Override
  public Description describe(Item item) throws CallException {
    HostPort where = Optional.ofNullable(devices.addresses().get(item.name())).orElseThrow(() -> gone(item));
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("address", where.toString());
    Outcome<List<String>> targets = new PortAdmin(wires.options()).targets(where);
    facts.put("says to", targets instanceof Outcome.Done<List<String>> done
        ? done.value().isEmpty() ? "nobody" : String.join(", ", done.value())
        : targets.reason());
    try {
      facts.put("accepts", String.join(", ", wires.names().get(item.name(), "accepts")));
    } catch (IOException e) {
      facts.put("accepts", e.getMessage());
    }
    boolean asked = item.kind() == Kind.SERVICE;
    return new Description(item, facts,
        asked ? Optional.of("# one bottle as text, such as [get] [axes]\nstring " + YarpCalls.ARGUMENT + "\n")
            : Optional.empty(),
        asked ? Optional.of(new RecordShape(item.name(),
            List.of(new RecordShape.Field(YarpCalls.ARGUMENT, new FieldShape.Text())), List.of())) : Optional.empty(),
        Optional.empty());
  }

  /** Each port would have to be asked for itself. */
  @Override
  public List<Link> links() {
    return List.of();
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException("YARP has no parameters; ask the port that has " + name);
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw gone(item);
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    throw gone(item);
  }

  private static CallException gone(Item item) {
    return new CallException("the name server has no " + item.name() + " (any more)");
  }
}
