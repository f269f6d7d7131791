package org.robotui.rtps.internal.participant;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.rtps.Discovery;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.internal.discovery.DiscoveredParticipants;

/** What users see of who is there. */
record DiscoveryView(DiscoveredParticipants discovered) implements Discovery {

  @Override
  public List<ParticipantInfo> participants() {
    return discovered.participants();
  }

  @Override
  public Optional<ParticipantInfo> participant(GuidPrefix prefix) {
    return discovered.participant(prefix);
  }

  @Override
  public OptionalLong heardNanos(GuidPrefix prefix) {
    return discovered.heardNanos(prefix);
  }

  @Override
  public List<EndpointInfo> endpoints() {
    return discovered.endpoints();
  }

  @Override
  public void addListener(DiscoveryListener listener) {
    discovered.addListener(listener);
  }

  @Override
  public void removeListener(DiscoveryListener listener) {
    discovered.removeListener(listener);
  }
}
