package org.robotui.rfic.yarp.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.rfic.yarp.internal.call.YarpPorts;
import org.robotui.rfic.yarp.internal.feed.ModelFile;

/** The type {@code yarp}: the ports that a name server of YARP knows. */
@Component(service = RficType.class)
public final class YarpRficType implements RficType {
  /** Streams and commands are those of the ports that are registered; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("yarp", "YARP",
      "Ports of YARP's devices, found by asking the name server which there are.",
      YarpSettings.SCHEMA, List.of(YarpPorts.SERVICES, YarpPorts.GRAPH));

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public List<SettingFault> faults(Settings settings) {
    return YarpSettings.urdf(settings).stream()
        .flatMap(file -> ModelFile.of(file).fault().map(file::fault).stream()).toList();
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return YarpSessions.rfic(context, YarpSettings.of(settings, System.getenv()));
  }
}
