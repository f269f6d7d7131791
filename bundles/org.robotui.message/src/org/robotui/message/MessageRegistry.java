package org.robotui.message;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.net.collection.LruMap;

/**
 * All message and service types known: those shipped with this library, those installed on this machine, and those
 * learned from the connection headers of peers. Safe for use by several threads.
 */
public final class MessageRegistry implements DefinitionSource {

  private static final int MAX_LEARNED = 500;

  private final ShippedDefinitions shipped;
  private final Generation generation;
  private final LocalDefinitions local;
  private final Map<MessageInfo, MessageSchema> learned = new LruMap<>(MAX_LEARNED);

  /**
   * Creates a registry.
   *
   * @param local the definitions of this machine
   */
  public MessageRegistry(LocalDefinitions local) {
    this(local, Generation.ROS1);
  }

  /**
   * Creates a registry.
   *
   * @param local the definitions of this machine
   * @param generation whose definitions peers send, and whose version of a shipped type is meant
   */
  public MessageRegistry(LocalDefinitions local, Generation generation) {
    this.local = local;
    this.generation = generation;
    this.shipped = new ShippedDefinitions(generation);
  }

  /**
   * Creates a registry that looks where ROS does.
   *
   * @return a registry of the process's environment
   */
  public static MessageRegistry fromEnvironment() {
    return new MessageRegistry(LocalDefinitions.fromEnvironment(System.getenv()));
  }

  /**
   * The type that a peer announced, from the definition in its connection header, or where it sent none from the
   * definitions known here. A type is remembered.
   *
   * @param peer what the peer announced
   * @return the type, or why it cannot be decoded
   */
  public SchemaLookup<MessageSchema> learn(MessageInfo peer) {
    if (peer.definition().isBlank() && !hasEmptyBody(peer)) {
      return message(peer.type(), peer.md5());
    }
    synchronized (learned) {
      MessageSchema known = learned.get(peer);
      return known != null ? new SchemaLookup.Found<>(known) : parse(peer);
    }
  }

  private static boolean hasEmptyBody(MessageInfo peer) {
    return peer.md5().equals("d41d8cd98f00b204e9800998ecf8427e");
  }

  private SchemaLookup<MessageSchema> parse(MessageInfo peer) {
    try {
      MessageSchema schema = MessageSchema.parse(peer.type(), peer.definition(), generation);
      if (!peer.accepts(schema.info().md5())) {
        return new SchemaLookup.Missing<>("the definition of " + peer.type() + " in the connection header has"
            + " the sum " + schema.info().md5() + ", but the peer announced " + peer.md5());
      }
      learned.put(peer, schema);
      return new SchemaLookup.Found<>(schema);
    } catch (DefinitionException e) {
      return new SchemaLookup.Missing<>(e.getMessage());
    }
  }

  /**
   * A message type by name.
   *
   * @param type the full name, such as {@code nav_msgs/Odometry}; requests and responses of services are named
   * {@code <service>Request} and {@code <service>Response}
   * @return the type, shipped, local or learned, in this order, or why there is none
   */
  public SchemaLookup<MessageSchema> message(String type) {
    return message(type, MessageInfo.ANY);
  }

  /**
   * A message type by name and sum.
   *
   * @param name the full name
   * @param md5 the sum it must have, or {@code *}
   * @return the type, or why there is none
   */
  public SchemaLookup<MessageSchema> message(String name, String md5) {
    String type = Generation.plainName(name);
    Candidates<MessageSchema> candidates = new Candidates<>("message", type, md5);
    candidates.add(() -> resolve(shipped.find(type)), MessageRegistry::md5);
    candidates.add(() -> resolve(local.find(type)), MessageRegistry::md5);
    for (MessageSchema each : learnedTypes()) {
      if (each.definition().type().equals(type)) {
        candidates.add(() -> Optional.of(each), MessageRegistry::md5);
      }
    }
    candidates.add(() -> resolve(learnedDefinition(type)), MessageRegistry::md5);
    return candidates.result();
  }

  /**
   * A service type by name. Connection headers do not carry service definitions, so it must be shipped or local.
   *
   * @param type the full name, such as {@code std_srvs/SetBool}
   * @return the type, or why there is none
   */
  public SchemaLookup<ServiceSchema> service(String type) {
    return service(type, MessageInfo.ANY);
  }

  /**
   * A service type by name and sum.
   *
   * @param name the full name
   * @param md5 the sum the server announced, or {@code *}
   * @return the type, or why there is none
   */
  public SchemaLookup<ServiceSchema> service(String name, String md5) {
    String type = Generation.plainName(name);
    Candidates<ServiceSchema> candidates = new Candidates<>("service", type, md5);
    candidates.add(() -> resolveService(shipped.service(type)), ServiceSchema::md5);
    candidates.add(() -> resolveService(local.service(type)), ServiceSchema::md5);
    return candidates.result();
  }

  @Override
  public Optional<MessageDefinition> find(String type) throws DefinitionException {
    Optional<MessageDefinition> known = shipped.find(type);
    if (known.isEmpty()) {
      known = local.find(type);
    }
    return known.isPresent() ? known : learnedDefinition(type);
  }

  private static String md5(MessageSchema schema) {
    return schema.info().md5();
  }

  private Optional<MessageSchema> resolve(Optional<MessageDefinition> definition) throws DefinitionException {
    return definition.isEmpty() ? Optional.empty() : Optional.of(MessageSchema.resolve(definition.get(), this));
  }

  private Optional<ServiceSchema> resolveService(Optional<ServiceDefinition> definition) throws DefinitionException {
    return definition.isEmpty() ? Optional.empty() : Optional.of(ServiceSchema.resolve(definition.get(), this));
  }

  private Optional<MessageDefinition> learnedDefinition(String type) {
    return learnedTypes().stream()
        .flatMap(schema -> schema.definitionOf(type).stream())
        .findFirst();
  }

  private List<MessageSchema> learnedTypes() {
    synchronized (learned) {
      return new ArrayList<>(learned.values());
    }
  }
}
