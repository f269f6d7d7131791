package org.robotui.core.internal.match;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.Samples;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Pose;
import org.robotui.data.geometry.Twist;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.LaserScan;

class MatcherTest {
  private static final Supplier BASE = new Supplier("base", true, "");
  private static final Supplier CONNECTING = new Supplier("base", false, "is connecting");

  private final List<Have> haves = new ArrayList<>();
  private final List<Supplier> suppliers = new ArrayList<>(List.of(BASE));
  private final Map<SourceId, Choice> choices = new HashMap<>();

  private static SourceId id(String text) {
    int dot = text.indexOf('.');
    return new SourceId(text.substring(0, dot), text.substring(dot + 1));
  }

  private static <T extends Data> StreamPort<T> stream(String name, Class<T> type, Arity arity) {
    return new StreamPort<>(name, type, arity, "");
  }

  private <T extends Data> MatcherTest offers(String id, Class<T> type) {
    return offers(id, stream(id(id).port(), type, Arity.ONE));
  }

  private MatcherTest offers(String id, Port port) {
    haves.add(new Have(id(id), port));
    return this;
  }

  private MatcherTest named(String port, String... peers) {
    choices.put(id(port), new Choice(Stream.of(peers).map(MatcherTest::id).toList(), "robot.yaml:12"));
    return this;
  }

  private Match match(Port port) {
    return Matcher.match(List.of(new Want(new SourceId("map", port.name()), port)), haves, suppliers, choices)
        .getFirst();
  }

  private static void assertConnected(Match match, String... peers) {
    assertEquals(MatchState.CONNECTED, match.state(), match.reason());
    assertEquals(Stream.of(peers).map(MatcherTest::id).toList(), match.peers());
  }

  private static void assertState(MatchState state, String reason, Match match) {
    assertEquals(state, match.state(), match.reason());
    assertTrue(match.reason().contains(reason), match.reason());
    assertEquals(List.of(), match.peers());
  }

  @Test
  void onlyCandidateIsConnectedWhateverItsName() {
    assertConnected(offers("base.laser", LaserScan.class).offers("base.odom", Odometry.class).match(Samples.SCAN),
        "base.laser");
  }

  @Test
  void producedTypeMayExtendTheAcceptedOne() {
    assertConnected(offers("base.odom", Odometry.class).match(Samples.POSE), "base.odom");
  }

  @Test
  void producedTypeMustNotBeMoreGeneral() {
    assertState(MatchState.REFUSED, "map needs Odometry on 'odom'; base offers Pose 'pose'",
        offers("base.pose", Pose.class).match(Samples.ODOM));
  }

  @Test
  void commandsGoTheOtherWayRound() {
    CommandPort<Twist> acceptsTwist = new CommandPort<>("drive", Twist.class, Arity.ONE, "");
    assertConnected(offers("base.drive", acceptsTwist).match(Samples.VELOCITY), "base.drive");
    haves.clear();
    CommandPort<Twist> givesTwist = new CommandPort<>("cmd_vel", Twist.class, Arity.ONE, "");
    CommandPort<VelocityCommand> acceptsVelocity = new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.ONE, "");
    assertState(MatchState.REFUSED,
        "map sends Twist on 'cmd_vel'; no program of the robot subscribes to it: start the one that does, and it connects by itself"
            + " (base accepts VelocityCommand 'cmd_vel')",
        offers("base.cmd_vel", acceptsVelocity).match(givesTwist));
  }

  @Test
  void callsNeedRequestAndReply() {
    CallPort<Integer, Number> asks = new CallPort<>("call", Integer.class, Number.class, Arity.ONE, "");
    assertConnected(offers("base.a", new CallPort<>("a", Number.class, Integer.class, Arity.ONE, "")).match(asks),
        "base.a");
    haves.clear();
    assertState(MatchState.REFUSED, "base answers Integer -> Object 'b'",
        offers("base.b", new CallPort<>("b", Integer.class, Object.class, Arity.ONE, "")).match(asks));
    haves.clear();
    assertState(MatchState.REFUSED, "base answers String -> Number 'c'",
        offers("base.c", new CallPort<>("c", String.class, Number.class, Arity.ONE, "")).match(asks));
  }

  private List<Match> matchOneAndAll() {
    Port one = new CommandPort<>("goal", Twist.class, Arity.OPTIONAL, "");
    Port all = new CommandPort<>("goals", Twist.class, Arity.MANY, "");
    return Matcher.match(Stream.of(one, all).map(p -> new Want(new SourceId("map", p.name()), p)).toList(), haves,
        suppliers, choices);
  }

  @Test
  void aPortForOneRobotIsNoQuestionWhereAnotherTakesAllOfThem() {
    suppliers.add(new Supplier("keira", true, ""));
    CommandPort<Twist> takes = new CommandPort<>("goal", Twist.class, Arity.ONE, "");
    offers("base.move_base/goal", takes).offers("keira.planner:0/goal", takes);
    List<Match> matches = matchOneAndAll();
    assertState(MatchState.REFUSED, "not needed: 'goals' takes all 2 ports of its type", matches.getFirst());
    assertTrue(matches.getFirst().reason().contains("map.goal: base.move_base/goal"), matches.getFirst().reason());
    assertConnected(matches.getLast(), "base.move_base/goal", "keira.planner:0/goal");
    named("map.goal", "keira.planner:0/goal");
    assertConnected(matchOneAndAll().getFirst(), "keira.planner:0/goal");
  }

  @Test
  void ofSeveralThatOneRobotTakesOneHasToBeChosen() {
    CommandPort<Twist> takes = new CommandPort<>("", Twist.class, Arity.ONE, "");
    offers("base.near", takes).offers("base.far", takes);
    assertState(MatchState.AMBIGUOUS, "2 are of this type", matchOneAndAll().getFirst());
  }

  @Test
  void browsersFitBrowsersOnly() {
    offers("base.scan", LaserScan.class).offers("base.ros", new BrowsePort("ros", Arity.ONE, ""));
    assertConnected(match(Samples.BROWSE), "base.ros");
  }

  @Test
  void oneNameInTwoKindsIsTwoPorts() {
    offers("base.cmd_vel", VelocityCommand.class).offers("base.cmd_vel", Samples.VELOCITY);
    assertConnected(match(Samples.VELOCITY), "base.cmd_vel");
    assertConnected(match(stream("cmd_vel", VelocityCommand.class, Arity.ONE)), "base.cmd_vel");
  }

  @Test
  void ofSeveralTheOneWithTheNameOfThePortIsTaken() {
    offers("base./robot/scan", LaserScan.class).offers("base./robot/rear", LaserScan.class);
    assertConnected(match(Samples.SCAN), "base./robot/scan");
  }

  @Test
  void ofSeveralThatEndWithTheNameTheOneThatIsCalledSoIsTakenWithinOneInterface() {
    offers("base.scan", LaserScan.class).offers("base.front/scan", LaserScan.class);
    assertConnected(match(Samples.SCAN), "base.scan");
    suppliers.add(new Supplier("other", true, ""));
    offers("other.rear/scan", LaserScan.class);
    assertState(MatchState.AMBIGUOUS, "3 are of this type", match(Samples.SCAN));
  }

  @Test
  void severalWithoutADifferenceAreAmbiguousAndTheLineThatDecidesIsTold() {
    Match match = offers("base.front", LaserScan.class).offers("base.rear", LaserScan.class).match(Samples.SCAN);
    assertState(MatchState.AMBIGUOUS, "Write under 'connect':  map.scan: base.front", match);
    assertEquals(List.of(id("base.front"), id("base.rear")), match.candidates());
  }

  @Test
  void oneNameOfTwoRobotsIsAmbiguous() {
    suppliers.add(new Supplier("other", true, ""));
    Match match = offers("base.laser", LaserScan.class).offers("base.scan", LaserScan.class)
        .offers("other.scan", LaserScan.class).match(Samples.SCAN);
    assertState(MatchState.AMBIGUOUS, "3 are of this type: base.laser, base.scan, other.scan", match);
    assertTrue(match.reason().endsWith("map.scan: base.scan"));
  }

  @Test
  void manyTakesAllThatFit() {
    offers("base.front", LaserScan.class).offers("base.rear", LaserScan.class).offers("base.map", GridMap.class);
    assertConnected(match(stream("scans", LaserScan.class, Arity.MANY)), "base.front", "base.rear");
    assertConnected(match(stream("all", Data.class, Arity.MANY)), "base.front", "base.rear", "base.map");
  }

  @Test
  void nothingThatFitsIsRefusedWithWhatThereIs() {
    Match match = offers("base.scan", LaserScan.class).offers("base.odom", Odometry.class).match(Samples.MAP);
    assertEquals("map needs GridMap on 'map'; base offers LaserScan 'scan', Odometry 'odom'", match.reason());
    assertEquals(MatchState.REFUSED, match.state());
  }

  @Test
  void longListsOfOffersAreCut() {
    for (int i = 0; i < 20; i++) {
      offers("base.scan" + i, LaserScan.class);
    }
    assertState(MatchState.REFUSED, "LaserScan 'scan7' and 12 more", match(Samples.MAP));
  }

  @Test
  void nothingYetIsPendingWhileARobotInterfaceIsNotReady() {
    suppliers.set(0, CONNECTING);
    assertState(MatchState.PENDING, "map needs GridMap on 'map'; base is connecting", match(Samples.MAP));
  }

  @Test
  void whatFitsIsConnectedAlsoWhileMoreMayCome() {
    suppliers.set(0, CONNECTING);
    assertConnected(offers("base.map", GridMap.class).match(Samples.MAP), "base.map");
  }

  @Test
  void optionalPortSaysThatTheViewWorksWithout() {
    assertState(MatchState.REFUSED, "; it works without", match(stream("map", GridMap.class, Arity.OPTIONAL)));
  }

  @Test
  void withoutRobotInterfaceItSaysSo() {
    suppliers.clear();
    assertState(MatchState.REFUSED, "there is no robot interface", match(Samples.MAP));
  }

  @Test
  void namedPeerWinsOverAmbiguityAndName() {
    offers("base.scan", LaserScan.class).offers("base.rear", LaserScan.class).named("map.scan", "base.rear");
    Match match = match(Samples.SCAN);
    assertConnected(match, "base.rear");
    assertTrue(match.reason().contains("robot.yaml:12"));
  }

  @Test
  void namedPeerThatIsNotThereIsPendingEvenIfAnotherFits() {
    offers("base.scan", LaserScan.class).named("map.scan", "base.rear");
    assertState(MatchState.PENDING, "base.rear, named by robot.yaml:12, is not there; base offers LaserScan 'scan'",
        match(Samples.SCAN));
  }

  @Test
  void namedPeerOfAnotherTypeIsRefusedNamingBoth() {
    offers("base.odom", Odometry.class).named("map.scan", "base.odom");
    assertState(MatchState.REFUSED, "map needs LaserScan on 'scan'; base.odom, named by robot.yaml:12, is Odometry",
        match(Samples.SCAN));
  }

  @Test
  void namedRobotInterfaceThatDoesNotExistIsRefused() {
    named("map.scan", "bse.scan");
    assertState(MatchState.REFUSED, "no robot interface 'bse', named by robot.yaml:12; there are: base",
        match(Samples.SCAN));
  }

  @Test
  void portMayBeLeftUnconnected() {
    offers("base.scan", LaserScan.class).named("map.scan");
    assertState(MatchState.REFUSED, "left unconnected by robot.yaml:12", match(Samples.SCAN));
  }

  @Test
  void severalNamesNeedAPortThatTakesMany() {
    offers("base.a", LaserScan.class).offers("base.b", LaserScan.class).named("map.scan", "base.a", "base.b");
    assertState(MatchState.REFUSED, "one connection only; robot.yaml:12 names 2", match(Samples.SCAN));
  }

  @Test
  void ofSeveralNamesThoseThatAreThereAreConnectedAndTheOthersTold() {
    offers("base.a", LaserScan.class).offers("base.m", GridMap.class)
        .named("map.scans", "base.a", "base.b", "base.m");
    Match match = match(stream("scans", LaserScan.class, Arity.MANY));
    assertConnected(match, "base.a");
    assertTrue(match.reason().contains("base.b") && match.reason().contains("base.m"), match.reason());
  }

  @Test
  void sameQuestionHasTheSameAnswerInAnyOrderOfOffers() {
    offers("base.a", LaserScan.class).offers("base.scan", LaserScan.class).offers("base.o", Odometry.class)
        .offers("base.m", GridMap.class);
    List<Match> expected = List.of(match(Samples.SCAN), match(Samples.ODOM), match(Samples.MAP));
    Random random = new Random(1);
    for (int i = 0; i < 50; i++) {
      Collections.shuffle(haves, random);
      assertEquals(expected, List.of(match(Samples.SCAN), match(Samples.ODOM), match(Samples.MAP)));
    }
  }

  @Test
  void exchangeListsWhatUsedConnectionsWouldMiss() {
    offers("base.scan", LaserScan.class).offers("base.odom", Odometry.class).offers("base.map", GridMap.class);
    List<Want> wants = List.of(new Want(id("map.scan"), Samples.SCAN), new Want(id("map.odom"), Samples.ODOM));
    List<Match> matches = Matcher.match(wants, haves, suppliers, choices);
    List<Port> enough = List.of(stream("/laser", LaserScan.class, Arity.ONE), stream("/o", Odometry.class, Arity.ONE));
    assertEquals(List.of(), missing(wants, matches, "base", enough), "the unused map need not be covered");
    assertEquals(List.of("map needs Odometry on 'odom'; the replacement has nothing that fits"),
        missing(wants, matches, "base", enough.subList(0, 1)));
    assertEquals(List.of(), missing(wants, matches, "other", List.of()));
  }

  @Test
  void whereTheViewChoosesWhatFitsAreCandidatesAndNothingIsWantedYet() {
    StreamPort<Pose> chosen = new StreamPort<>("values", Pose.class, Arity.MANY, "", Intake.CHOSEN);
    Match match = offers("base.pose", Pose.class).offers("base.odom", Odometry.class).match(chosen);
    assertConnected(match);
    assertEquals(List.of(id("base.pose"), id("base.odom")), match.candidates());
    assertTrue(match.reason().contains("chooses among 2"), match.reason());
  }

  private static List<String> missing(List<Want> wants, List<Match> matches, String component,
      List<? extends Port> offered) {
    return Exchange.uncovered(wants, matches, component, offered).stream().map(Exchange::sentence).toList();
  }
}
