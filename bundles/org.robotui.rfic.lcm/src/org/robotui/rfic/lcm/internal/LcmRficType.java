package org.robotui.rfic.lcm.internal;

import java.util.List;
import java.util.stream.Collectors;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Placed;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.guard.Guards;
import org.robotui.rfic.lcm.internal.call.LcmPorts;

/** The type {@code lcm}: listens to the channels of LCM. */
@Component(service = RficType.class)
public final class LcmRficType implements RficType {
  /** Streams are those that are heard; only browsing and saying single messages are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("lcm", "LCM",
      "Channels of robots that speak LCM, found by listening; their types are read from .lcm files.",
      LcmSettings.SCHEMA, List.of(LcmPorts.CHANNELS, LcmPorts.PUBLISH));

  private final Guards guards = new Guards();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public List<SettingFault> faults(Settings settings) {
    SettingsReader reader = new SettingsReader(System.getenv());
    LcmSettings read = reader.read(settings);
    return reader.faults().isEmpty()
        ? TypeCheck.faults(read, settings.has("types") ? (Placed) settings.values().get("types") : Placed.nowhere(""))
        : reader.faults();
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    SettingsReader reader = new SettingsReader(System.getenv());
    LcmSettings read = reader.read(settings);
    if (!reader.faults().isEmpty()) {
      throw new IllegalArgumentException(
          reader.faults().stream().map(SettingFault::toString).collect(Collectors.joining("; ")));
    }
    return LcmSessions.rfic(context, read, guards);
  }
}
