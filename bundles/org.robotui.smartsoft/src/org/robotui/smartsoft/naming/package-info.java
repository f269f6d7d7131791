/**
 * The naming service of ACE/SmartSoft: what is entered there, a client, and a small one of our own for tests and
 * simulations. A naming service knows where services are; nothing but questions for that goes through it.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.smartsoft.naming;
