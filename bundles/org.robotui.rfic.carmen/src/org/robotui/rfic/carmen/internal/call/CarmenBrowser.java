package org.robotui.rfic.carmen.internal.call;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.module.ParamClient;
import org.robotui.rfic.carmen.internal.feed.Feeds;

/** What a central knows: its messages as topics and services, and the settings of the parameter daemon. */
public final class CarmenBrowser implements Browser {
  private final Feeds feeds;
  private final ParamClient params;

  public CarmenBrowser(Feeds feeds, ParamClient params) {
    this.feeds = feeds;
    this.params = params;
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    return switch (kind) {
      case TOPIC -> items(kind, false);
      case SERVICE -> items(kind, true);
      case PARAMETER -> parameters();
      case NODE, ACTION, TUNABLE -> List.of();
    };
  }

  private List<Item> items(Kind kind, boolean calls) {
    return feeds.known().values().stream().filter(form -> CarmenCalls.takes(form.name()) == calls)
        .map(form -> new Item(kind, form.name(), form.format().toString())).toList();
  }

  private List<Item> parameters() throws CallException {
    List<Item> items = new ArrayList<>();
    try {
      for (String module : params.modules()) {
        params.all(module).keySet().forEach(name -> items.add(new Item(Kind.PARAMETER, module + "/" + name, "")));
      }
      return items;
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  @Override
  public Description describe(Item item) throws CallException {
    if (item.kind() == Kind.PARAMETER) {
      return new Description(item, Map.of("value", String.valueOf(parameter(item.name()).orElse(""))),
          Optional.empty(), Optional.empty(), Optional.empty());
    }
    IpcForm form = feeds.find(item.name()).orElseThrow(() -> gone(item));
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("format", form.format().toString());
    facts.put("handled", feeds.isHandled(form.name()) ? "by a program" : "by nobody");
    return new Description(item, facts, Optional.of(CarmenShapes.text(form)), Optional.of(CarmenShapes.of(form)),
        Optional.empty());
  }

  /** Who publishes what is not known to a central. */
  @Override
  public List<Link> links() {
    return List.of();
  }

  private record Place(String module, String variable) {
    static Place of(String name) throws CallException {
      int slash = name.indexOf('/');
      if (slash <= 0) {
        throw new CallException("'" + name + "' is no parameter of CARMEN; they are named as in robot/max_t_vel");
      }
      return new Place(name.substring(0, slash), name.substring(slash + 1));
    }
  }

  @Override
  public Optional<Object> parameter(String name) throws CallException {
    Place place = Place.of(name);
    try {
      return params.get(place.module(), place.variable()).map(Object.class::cast);
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    Place place = Place.of(name);
    String text = value instanceof Boolean flag ? flag ? "on" : "off" : String.valueOf(value);
    try {
      params.set(place.module(), place.variable(), text)
          .orElseThrow(() -> new CallException("the parameter daemon did not take " + name));
    } catch (IOException e) {
      throw new CallException(e.getMessage(), e);
    }
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
    return new CallException("the central has no " + item.name() + " (any more)");
  }
}
