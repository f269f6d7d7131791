/**
 * What somebody needs to know who helps, gathered in one file: of this process, of others that run, and of what they
 * have kept. It needs nothing but a Java, as it is wanted most where nothing else starts.
 */
package org.robotui.core.internal.facts;
