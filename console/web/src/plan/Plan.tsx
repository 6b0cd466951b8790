export default function Plan() {
  return <p>Plan</p>;
}
