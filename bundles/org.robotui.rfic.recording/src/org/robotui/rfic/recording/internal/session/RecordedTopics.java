package org.robotui.rfic.recording.internal.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.LongSupplier;
import org.robotui.api.replay.StreamHistory;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.HistoryConversion;
import org.robotui.message.topic.PromptPublisher;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.message.topic.TopicSettings;
import org.robotui.message.topic.TopicSubscription;

/** The topics of a recording. Nothing can be published on them. Safe for all threads. */
final class RecordedTopics implements TopicClient {
  private static final String NAME = "robotui";

  private final TopicTable table;
  private final RosDefinitions definitions;
  private final String file;
  private final LongSupplier time;
  private final Runnable changed;
  private final TopicSettings settings;
  private final RecordedHistory history;
  private final List<Reception<?>> receptions = new CopyOnWriteArrayList<>();

  /**
   * Nothing is wanted yet.
   *
   * @param file its name, for users
   * @param time what time it is in the recording
   * @param changed is told when something else is wanted; must not block
   * @param settings names ports
   * @param history reads them whole
   */
  RecordedTopics(TopicTable table, RosDefinitions definitions, String file, LongSupplier time, Runnable changed,
      TopicSettings settings, RecordedHistory history) {
    this.table = table;
    this.definitions = definitions;
    this.file = file;
    this.time = time;
    this.changed = changed;
    this.settings = settings;
    this.history = history;
  }

  /** What is wanted now. */
  List<Reception<?>> wanted() {
    return List.copyOf(receptions);
  }

  @Override
  public boolean isDefined(String topic) {
    return table.first(topic).map(each -> each.format().definition().isPresent()).orElse(true);
  }

  @Override
  public <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form, TopicListener<M> listener) {
    Reception<M> made = new Reception<>(new ReceptionRule<>(topic, type, form), table, file, settings.portName(topic),
        listener, each -> {
          receptions.remove(each);
          changed.run();
        });
    receptions.add(made);
    changed.run();
    return made;
  }

  @Override
  public <M> Optional<StreamHistory> history(String port, String topic, String type, MessageForm<M> form,
      HistoryConversion<M> conversion) {
    history.add(new HistoryStream<>(port, new ReceptionRule<>(topic, type, form), conversion));
    return Optional.of(history);
  }

  @Override
  public <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting) {
    return PromptPublisher.unheard();
  }

  @Override
  public TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema) {
    return PromptPublisher.unheard();
  }

  @Override
  public SchemaLookup<MessageSchema> schema(String type) {
    Optional<MessageSchema> recorded = table.all().flatMap(each -> each.format().definition().stream())
        .filter(each -> each.definition().type().equals(type)).findFirst();
    return recorded.<SchemaLookup<MessageSchema>>map(SchemaLookup.Found::new)
        .orElseGet(() -> definitions.of(type, table.generation()));
  }

  @Override
  public Optional<String> failure(String topic) {
    return table.of(topic).stream().flatMap(each -> each.format().obstacle().stream()).findFirst()
        .or(() -> receptions.stream().filter(each -> each.topic().equals(topic)).map(Reception::failure)
            .filter(reason -> !reason.isEmpty()).findFirst());
  }

  @Override
  public boolean isSimulated() {
    return true;
  }

  @Override
  public long nowNanos() {
    return time.getAsLong();
  }

  @Override
  public String name() {
    return NAME;
  }
}
