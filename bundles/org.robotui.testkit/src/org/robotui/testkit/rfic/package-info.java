/**
 * What every robot interface keeps, whatever its framework: a list of checks that run against a robot of that
 * framework, which the test of the robot interface brings as a {@link org.robotui.testkit.rfic.Peer}. Knows no test
 * framework: a check that fails throws an {@code AssertionError}. How to use it stands in
 * {@code docs/rfic-contract.md}.
 */
@org.osgi.annotation.versioning.Version("1.3.0")
package org.robotui.testkit.rfic;
