package org.robotui.recorder.internal;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.osgi.framework.BundleContext;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Deactivate;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.host.Host;
import org.robotui.api.host.Host.Subscription;
import org.robotui.api.record.Recorder;
import org.robotui.api.record.RecorderState;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingOutcome;
import org.robotui.api.record.RecordingPlan;
import org.robotui.recorder.internal.file.RecorderCore;

/** The recorder as an OSGi service. It is loaded when somebody asks for it. */
@Component(service = Recorder.class)
public final class RecorderComponent implements Recorder {
  private final RecorderCore recorder;

  /** Called by declarative services. */
  @Activate
  public RecorderComponent(@Reference Host host, BundleContext context) {
    recorder = new RecorderCore(host, context.getBundle().getVersion().toString());
  }

  @Deactivate
  void deactivate() {
    recorder.close();
  }

  @Override
  public Optional<String> obstacle(RecordingPlan plan) {
    return recorder.obstacle(plan);
  }

  @Override
  public RecordingOutcome start(RecordingPlan plan) {
    return recorder.start(plan);
  }

  @Override
  public RecordingOutcome stop() {
    return recorder.stop();
  }

  @Override
  public RecordingOutcome keepRecent(Duration limit, RecordingChoice choice) {
    return recorder.keepRecent(limit, choice);
  }

  @Override
  public void forgetRecent() {
    recorder.forgetRecent();
  }

  @Override
  public RecordingOutcome saveRecent(Path target) {
    return recorder.saveRecent(target);
  }

  @Override
  public RecorderState state() {
    return recorder.state();
  }

  @Override
  public Subscription listen(Runnable listener) {
    return recorder.listen(listener);
  }
}
