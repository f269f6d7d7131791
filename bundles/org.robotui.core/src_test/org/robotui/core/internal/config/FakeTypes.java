package org.robotui.core.internal.config;

import java.util.List;
import java.util.Optional;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.RuicType;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.layout.Layout;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.core.internal.config.model.TypeLookup;

/** The types ros, map, camera and base, readable only. */
final class FakeTypes implements TypeLookup {
  private static final Schema ROS = Schema.of(Setting.required("master", new ValueType.Text(), "the master"),
      Setting.optional("folder", new ValueType.WithPlace(new ValueType.Text()), "a folder"));
  private static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, "calls");
  private static final Schema MAP = Schema.of(Setting.of("follow", new ValueType.Flag(), false, "follow"));

  @Override
  public Optional<RficType> rfic(String id) {
    return "ros".equals(id) ? Optional.of(new Ros()) : Optional.empty();
  }

  @Override
  public Optional<UicType> uic(String id) {
    return uicIds().contains(id) ? Optional.of(new View(id, "map".equals(id) ? MAP : Schema.EMPTY)) : Optional.empty();
  }

  @Override
  public Optional<RuicType> ruic(String id) {
    return "base".equals(id) ? Optional.of(new Base()) : Optional.empty();
  }

  @Override
  public List<String> rficIds() {
    return List.of("ros");
  }

  @Override
  public List<String> uicIds() {
    return List.of("camera", "map");
  }

  @Override
  public List<String> ruicIds() {
    return List.of("base");
  }

  private record Ros() implements RficType {
    @Override
    public Descriptor descriptor() {
      return new Descriptor("ros", "ROS", "", ROS, List.of(SERVICES));
    }

    @Override
    public List<SettingFault> faults(Settings settings) {
      return settings.has("folder") && settings.values().get("folder") instanceof Placed folder
          ? List.of(folder.fault("no folder " + folder.resolve(folder.value().toString())))
          : List.of();
    }

    @Override
    public Rfic create(RficContext context, Settings settings) {
      throw new UnsupportedOperationException("only read here");
    }
  }

  private record View(String id, Schema schema) implements UicType {
    @Override
    public Descriptor descriptor() {
      return new Descriptor(id, id, "", schema, List.of());
    }

    @Override
    public Surface surface() {
      return Surface.WINDOW;
    }

    @Override
    public double rateHz() {
      return 10;
    }

    @Override
    public Uic create(UicContext context, Settings settings) {
      throw new UnsupportedOperationException("only read here");
    }
  }

  private record Base() implements RuicType {
    @Override
    public Descriptor descriptor() {
      return new Descriptor("base", "Base", "", Schema.EMPTY, List.of());
    }

    @Override
    public List<UicSpec> uics(Settings settings) {
      return List.of(new UicSpec("map", "map"), new UicSpec("camera", "camera"));
    }

    @Override
    public Layout layout(Settings settings) {
      return new Layout.Tabs(List.of("map", "camera"));
    }
  }
}
